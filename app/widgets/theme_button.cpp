#include "widgets/theme_button.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>

#include "widgets/controls.h"
#include "widgets/look.h"
#include "widgets/rail.h"

namespace breakaway {

namespace {

QString nameOf(Theme theme) {
  return theme == Theme::light  ? ThemeButton::tr("Light")
         : theme == Theme::dark ? ThemeButton::tr("Dark")
                                : ThemeButton::tr("System");
}

/// Each in its own words, so that whoever reads no other finds it.
QString nameOf(Language language) {
  return language == Language::english  ? QStringLiteral("English")
         : language == Language::german ? QStringLiteral("Deutsch")
                                        : ThemeButton::tr("System's language");
}

}  // namespace

ThemeButton::ThemeButton(QWidget* parent) : QPushButton(parent) {
  setObjectName("themeButton");
  setAccessibleName(tr("Colours and language of the window"));
  setToolTip(tr("Colours of the window: light, dark, or as the desktop has them; and its language"));
  setProperty("role", "bare");
  setFixedSize(Rail::width_px, 32);
  text_ = new QLabel(this);
  text_->setAttribute(Qt::WA_TransparentForMouseEvents);
  rowIn(this, 0, {14, 0, 24, 0})->addWidget(text_);
  auto* menu = new QMenu(this);
  auto* group = new QActionGroup(menu);
  for (const Theme theme : {Theme::system, Theme::light, Theme::dark}) {
    QAction* action = menu->addAction(nameOf(theme));
    action->setCheckable(true);
    action->setChecked(theme == keptTheme());
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, theme] {
      keepTheme(theme);
      wear(theme);
      showTheme();
    });
  }
  menu->addSeparator();
  auto* languages = new QActionGroup(menu);
  for (const Language language : {Language::system, Language::english, Language::german}) {
    QAction* action = menu->addAction(nameOf(language));
    action->setCheckable(true);
    action->setChecked(language == keptLanguage());
    languages->addAction(action);
    connect(action, &QAction::triggered, this, [this, language] { emit languageChosen(language); });
  }
  setMenu(menu);
  showTheme();
}

void ThemeButton::showTheme() {
  text_->setText(tr("Colours: %1").arg(nameOf(keptTheme()).toLower()));
}

}  // namespace breakaway

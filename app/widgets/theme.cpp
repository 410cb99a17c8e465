// Which look the application wears.
#include <QApplication>
#include <QDBusInterface>
#include <QDBusReply>
#include <QDBusVariant>
#include <QSettings>
#include <QStyleFactory>

#include "widgets/look.h"
#include "widgets/style_sheet.h"

namespace breakaway {

namespace {

constexpr int portalPatience_ms = 300;
constexpr uint preferDark = 1;  // of the portal's org.freedesktop.appearance color-scheme

QSettings kept() {
  return QSettings("breakaway", "window");
}

/// The desktop's own, before the program's is set.
bool firstPaletteIsDark() {
  static const bool dark = QApplication::palette().color(QPalette::Window).lightness() < 128;
  return dark;
}

}  // namespace

Theme keptTheme() {
  const QString name = kept().value("theme").toString();
  return name == "light" ? Theme::light : name == "dark" ? Theme::dark : Theme::system;
}

void keepTheme(Theme theme) {
  kept().setValue("theme", theme == Theme::light ? "light" : theme == Theme::dark ? "dark" : "system");
}

bool desktopIsDark() {
  if (QDBusConnection::sessionBus().isConnected()) {
    QDBusInterface portal("org.freedesktop.portal.Desktop", "/org/freedesktop/portal/desktop",
                          "org.freedesktop.portal.Settings");
    portal.setTimeout(portalPatience_ms);
    const QDBusReply<QDBusVariant> reply = portal.call("Read", "org.freedesktop.appearance", "color-scheme");
    // The answer is a variant in a variant.
    if (reply.isValid()) return reply.value().variant().value<QDBusVariant>().variant().toUInt() == preferDark;
  }
  return firstPaletteIsDark();
}

void wear(Theme theme) {
  const bool systemDark = theme == Theme::system && desktopIsDark();
  const Look& look = theme == Theme::dark || systemDark ? Look::inDark() : Look::light();
  firstPaletteIsDark();  // looked at while it is still the desktop's
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QFont font = QApplication::font();
  font.setPixelSize(static_cast<int>(Type::body));
  QApplication::setFont(font);
  QApplication::setPalette(paletteOf(look));
  qApp->setStyleSheet(styleSheet(look));
}

}  // namespace breakaway

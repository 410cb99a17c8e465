#include "session/language.h"

#include <QCoreApplication>
#include <QFile>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <algorithm>
#include <cstddef>

#include "diagnose/effects/catalogue.h"
#include "diagnose/model/effect.h"

namespace breakaway {

namespace {

constexpr const char* languageKey = "language";

struct Spoken {
  Language language = Language::english;
  Catalogue catalogue;
  QTranslator window, qt;
};

Spoken& spoken() {
  static Spoken one;
  return one;
}

/// Effects within an English sentence as words: "rising stiction". Their names as such are what files call them.
void nameInWords(std::string& text) {
  for (const Effect* effect : catalogue()) {
    const std::string name(effect->name());
    if (name.find('_') == std::string::npos) continue;
    for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + name.size()))
      std::replace(text.begin() + static_cast<std::ptrdiff_t>(at),
                   text.begin() + static_cast<std::ptrdiff_t>(at + name.size()), '_', ' ');
  }
}

}  // namespace

Language languageOf(const QString& code) {
  return code == "de" ? Language::german : code == "en" ? Language::english : Language::system;
}

Language keptLanguage() {
  return languageOf(QSettings("breakaway", "window").value(languageKey).toString());
}

void keepLanguage(Language language) {
  QSettings("breakaway", "window")
      .setValue(languageKey, language == Language::german    ? "de"
                             : language == Language::english ? "en"
                                                             : "system");
}

Result<Catalogue> catalogueOf(Language language) {
  QFile file(":/lang/core_de.json");
  if (language != Language::german || !file.open(QIODevice::ReadOnly)) return Error{"language", "has no catalogue"};
  return Catalogue::read(file.readAll().toStdString());
}

Catalogue wordsOf(Language language) {
  auto catalogue = catalogueOf(language);
  return catalogue ? std::move(*catalogue) : Catalogue();
}

Language spokenAs(Language language) {
  if (language != Language::system) return language;
  return QLocale::system().language() == QLocale::German ? Language::german : Language::english;
}

Language spokenLanguage() {
  return spoken().language;
}

void speak(Language language) {
  Spoken& now = spoken();
  now.language = language = spokenAs(language);
  QCoreApplication::removeTranslator(&now.window);
  QCoreApplication::removeTranslator(&now.qt);
  now.catalogue = {};
  if (language != Language::german) return;
  if (auto catalogue = catalogueOf(language)) now.catalogue = std::move(*catalogue);
  // Qt's own words, of its dialogs' buttons: where they are installed.
  if (now.qt.load("qtbase_de", QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&now.qt);
  if (now.window.load(":/lang/window_de.qm")) QCoreApplication::installTranslator(&now.window);
}

QString inLanguage(const Message& message) {
  std::string text = message.in(spoken().catalogue);
  // What came through plain text, as reasons for an end do, may be a message as a whole.
  const std::string* whole = text == message.english() ? spoken().catalogue.find(text) : nullptr;
  if (whole != nullptr) return QString::fromStdString(*whole);
  if (spokenLanguage() != Language::german) nameInWords(text);
  return QString::fromStdString(text);
}

QString nameInLanguage(const std::string& name) {
  // The second wave's amplitude is "amplitude2".
  const size_t digits = name.find_last_not_of("0123456789") + 1;
  const std::string* other = spoken().catalogue.find(name);
  const std::string* first = spoken().catalogue.find(name.substr(0, digits));
  std::string words = other != nullptr ? *other : first != nullptr ? *first + " " + name.substr(digits) : name;
  std::replace(words.begin(), words.end(), '_', ' ');
  const QString text = QString::fromStdString(words);
  return text.left(1).toUpper() + text.mid(1);
}

}  // namespace breakaway

// The window's language: which one was chosen, and what core says in it.
#pragma once

#include <QString>
#include <vector>

#include "base/catalogue.h"
#include "base/message.h"

namespace breakaway {

enum class Language { system, english, german };

/// The one that was chosen in the window; at first the system's.
Language keptLanguage();
/// For this start and later ones; speak() is what lets it be heard.
void keepLanguage(Language language);
/// By "en" or "de"; anything else: the system's.
Language languageOf(const QString& code);

/// From now on tr() and inLanguage() give this one; the system's, if it is neither, is English. A window that stands
/// already is made anew for it, see MainWindow::chooseLanguage().
void speak(Language language);
/// English or German.
Language spokenLanguage();
/// Which of the two this is here.
Language spokenAs(Language language);

/// What core says, in the language that the window speaks.
QString inLanguage(const Message& message);
/// A name that core has for files, "viscous_asymmetry", in words and in the window's language: "Viscous asymmetry".
QString nameInLanguage(const std::string& name);

/// Of a language that isn't English; empty, and an error, if this build holds none.
Result<Catalogue> catalogueOf(Language language);
/// The same for what is written in it; English where there is none.
Catalogue wordsOf(Language language);

}  // namespace breakaway

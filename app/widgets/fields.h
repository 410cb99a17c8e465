// What somebody has set and chosen in widgets, by their object names, for others of the same names: a page that is made
// anew, of the same parts of the session, then shows what the one before did.
#pragma once

#include <QMap>
#include <QVariant>

class QWidget;

namespace breakaway {

/// Numbers, texts, choices, ticks and what is chosen in lists and tables. A widget of ours that holds more than its
/// fields gives that as its user property `kept`, and takes it.
using Fields = QMap<QString, QVariant>;

/// Of `window` and all that has a name in it.
Fields fieldsIn(QWidget& window);
/// As a person would set them, those inside before those around them; what stands so already isn't touched.
void setFields(QWidget& window, const Fields& fields);

}  // namespace breakaway

// The look is the program's own, and can be read: contrasts, of the colours and of what is drawn with them.
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/window_support.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/number_text.h"

using namespace breakaway;
using namespace breakaway::test;

class TestLook : public QObject {
  Q_OBJECT
 private slots:
  void contrast_isAsDefined();
  void text_canBeRead_data();
  void text_canBeRead();
  void bordersAndCurves_canBeSeen_data();
  void bordersAndCurves_canBeSeen();
  void drawnText_hasTheContrast_data();
  void drawnText_hasTheContrast();
  void focus_isARing();
  void palette_tellsItsLook();
  void theme_isKept();
  void elidedLabel_asksForTheSameRoomWhateverItSays();
  void numbers_areReadable();

 private:
  const QTemporaryDir settings_;
};

namespace {

void bothLooks() {
  QTest::addColumn<bool>("dark");
  QTest::newRow("light") << false;
  QTest::newRow("dark") << true;
}

const Look& lookOf(bool dark) {
  return dark ? Look::inDark() : Look::light();
}

/// The highest contrast of any pixel against the most frequent colour: of text, that of its strokes.
double drawnContrast(const QImage& image) {
  QHash<QRgb, int> counts;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) ++counts[image.pixel(x, y)];
  }
  const QRgb back = std::max_element(counts.cbegin(), counts.cend()).key();
  double most = 1.0;
  for (auto one = counts.cbegin(); one != counts.cend(); ++one)
    most = std::max(most, contrast(QColor(back), QColor(one.key())));
  return most;
}

}  // namespace

void TestLook::contrast_isAsDefined() {
  QVERIFY(std::abs(contrast(Qt::black, Qt::white) - 21.0) < 1e-6);
  QVERIFY(std::abs(contrast(Qt::white, Qt::white) - 1.0) < 1e-9);
  QVERIFY(std::abs(contrast(QColor(0x777777), Qt::white) - 4.48) < 0.01);  // a grey that is known to just fail
}

void TestLook::text_canBeRead_data() {
  bothLooks();
}

void TestLook::text_canBeRead() {
  QFETCH(bool, dark);
  const Look& look = lookOf(dark);
  const std::tuple<const char*, QColor, QColor> pairs[] = {
      {"ink on page", look.ink, look.page},
      {"ink on surface", look.ink, look.surface},
      {"ink on selected", look.ink, look.selected},
      {"muted on page", look.muted, look.page},
      {"muted on surface", look.muted, look.surface},
      {"muted on selected", look.muted, look.selected},
      {"muted on simulated", look.muted, look.simulatedBack},
      {"disabled on page", look.disabled, look.page},
      {"disabled on surface", look.disabled, look.surface},
      {"accent on surface", look.accentLine, look.surface},
      {"accent on selected", look.accentLine, look.selected},
      {"white on accent", Qt::white, look.accent},
      {"white on stop", Qt::white, look.stop},
      {"trouble", look.trouble, look.troubleBack},
      {"trouble on surface", look.trouble, look.surface},
      {"warning", look.warning, look.warningBack},
      {"warning on surface", look.warning, look.surface},
      {"good", look.good, look.goodBack},
      {"good on surface", look.good, look.surface},
      {"simulated on surface", look.simulated, look.surface},
  };
  for (const auto& [name, text, back] : pairs) {
    const double found = contrast(text, back);
    QVERIFY2(found >= 4.5 && found < 21.0, qPrintable(QString("%1: %2").arg(name).arg(found)));
  }
}

void TestLook::bordersAndCurves_canBeSeen_data() {
  bothLooks();
}

void TestLook::bordersAndCurves_canBeSeen() {
  QFETCH(bool, dark);
  const Look& look = lookOf(dark);
  for (const QColor& back : {look.page, look.surface}) {
    QVERIFY2(contrast(look.border, back) >= 3.0, qPrintable(QString::number(contrast(look.border, back))));
    QVERIFY(contrast(look.accentLine, back) >= 3.0);
    QVERIFY(contrast(look.stopBorder, back) >= 3.0);
  }
  for (int k = 0; k < 5; ++k) {
    QVERIFY2(contrast(look.curve(k), look.surface) >= 3.0, qPrintable(QString("curve %1").arg(k)));
    for (int other = 0; other < k; ++other) QVERIFY(look.curve(k) != look.curve(other));
  }
}

void TestLook::drawnText_hasTheContrast_data() {
  bothLooks();
}

void TestLook::drawnText_hasTheContrast() {
  QFETCH(bool, dark);
  wear(dark ? Theme::dark : Theme::light);
  QWidget desk;
  auto* column = columnIn(&desk, 8, {16, 16, 16, 16});
  auto* frame = card(&desk);
  column->addWidget(frame);
  auto* primary = pushButton(frame, "primary", "Run");
  primary->setProperty("role", "primary");
  auto* disabled = pushButton(frame, "disabled", "Not now");
  disabled->setEnabled(false);
  auto* disabledBox = new QSpinBox(frame);
  disabledBox->setEnabled(false);
  auto* combo = new QComboBox(frame);
  combo->addItem("Map as CSV");
  const QList<QWidget*> texts{primary,
                              disabled,
                              disabledBox,
                              combo,
                              pushButton(frame, "plain", "Export"),
                              section(frame, "Averages"),
                              caption(frame, "95 % interval"),
                              explanation(frame, "What will move, and how far.")};
  for (QWidget* text : texts) columnOf(frame)->addWidget(text);
  desk.show();
  QVERIFY(QTest::qWaitForWindowExposed(&desk));
  for (QWidget* text : texts) {
    const double found = drawnContrast(text->grab(text->rect().adjusted(3, 3, -3, -3)).toImage());
    QVERIFY2(found >= 4.5, qPrintable(QString("%1: %2").arg(text->metaObject()->className()).arg(found)));
  }
  wear(Theme::light);
}

void TestLook::focus_isARing() {
  QWidget desk;
  auto* column = columnIn(&desk, 8, {16, 16, 16, 16});
  auto* button = pushButton(&desk, "one", "Export");
  auto* other = pushButton(&desk, "other", "Other");
  column->addWidget(button);
  column->addWidget(other);
  desk.show();
  desk.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&desk));
  other->setFocus();
  const QSize before = button->size();
  const QImage plain = button->grab().toImage();
  button->setFocus();
  const QImage ringed = button->grab().toImage();
  const QColor ring = ringed.pixelColor(ringed.width() / 2, 1);  // the second row: the ring is two pixels
  QCOMPARE(ring, Look::light().accentLine);
  QVERIFY(plain.pixelColor(plain.width() / 2, 1) != ring);
  QCOMPARE(button->size(), before);
}

void TestLook::palette_tellsItsLook() {
  QVERIFY(Look::of(paletteOf(Look::inDark())).dark);
  QVERIFY(!Look::of(paletteOf(Look::light())).dark);
}

void TestLook::theme_isKept() {
  qputenv("XDG_CONFIG_HOME", settings_.path().toUtf8());
  QCOMPARE(keptTheme(), Theme::system);
  keepTheme(Theme::dark);
  QCOMPARE(keptTheme(), Theme::dark);
  keepTheme(Theme::system);
  QCOMPARE(keptTheme(), Theme::system);
}

void TestLook::elidedLabel_asksForTheSameRoomWhateverItSays() {
  ElidedLabel label;
  label.setText("short");
  const QSize before = label.sizeHint();
  label.setText("a very much longer line that no slot in any bar has room for");
  QCOMPARE(label.sizeHint(), before);
  QCOMPARE(label.minimumSizeHint(), before);
}

void TestLook::numbers_areReadable() {
  QCOMPARE(numberText(0.38812), QString("0.388"));
  QCOMPARE(numberText(14.234), QString("14.2"));
  QCOMPARE(numberText(1034.6), QString("1035"));
  QCOMPARE(numberText(0.0), QString("0"));
  QCOMPARE(numberText(-0.0), QString("0"));
  QCOMPARE(numberText(std::nan("")), QString("–"));
  QCOMPARE(numberText(-0.25), QString("−0.250"));
  QCOMPARE(numberText(-14400.0), QString("−14\u202f400"));
  QCOMPARE(numberText(-3.1e-5, 2), QString("−3.1·10⁻⁵"));
  QCOMPARE(plainText(0.02), QString("0.02"));
  QCOMPARE(plainText(24.0), QString("24"));
  QCOMPARE(plainText(-65536.0), QString("−65\u202f536"));
  QCOMPARE(plainText(0.123456), QString("0.1235"));
  for (const double value : {-3.1e-5, 14400.0, -2.5, 0.0, 1.25e7}) QCOMPARE(numberIn(plainText(value)).value(), value);
  QCOMPARE(numberIn(" 2,5 ").value(), 2.5);
  QVERIFY(!numberIn("2 V") && !numberIn({}));
  QCOMPARE(fixedText(-0.001, 2), QString("0.00"));
  QCOMPARE(fixedText(-1.5, 1), QString("−1.5"));
  QCOMPARE(steadyNumber(-0.0004, 0.2), QString("0.000"));
  QCOMPARE(steadyNumber(1.23456, 1.0), QString("1.23"));
  QCOMPARE(estimateText({0.017, 0.00003}, 1e3, "mNm"), QString("17.00 ± 0.06 mNm"));
  QCOMPARE(estimateText({1.2345, 0.05}, 1.0, "Ω"), QString("1.23 ± 0.10 Ω"));
  QCOMPARE(estimateText({0.000123, 2.0}, 1.0, "Ω"), QString("0.00 ± 3.92 Ω"));
  QCOMPARE(estimateText({1.2345, 0.0}, 1.0, "Ω"), QString("1.23 Ω"));
}

JOURNEY_MAIN(TestLook)
#include "tst_look.moc"

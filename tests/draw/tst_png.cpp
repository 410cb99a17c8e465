#include <QImage>
#include <QTest>

#include "draw/png.h"
#include "draw/svg_plot.h"
#include "support/temporary.h"

using namespace breakaway;

class TestPng : public QObject {
  Q_OBJECT
 private slots:
  void figure_isDrawnOnWhiteWithItsCurve();
  void brokenPicture_leavesNothing();
  void missingProgram_isNamed();
};

void TestPng::figure_isDrawnOnWhiteWithItsCurve() {
  test::TemporaryFolder folder;
  Figure figure{"A ramp", "time / s", "speed / rad/s", {{"ramp", {0.0, 1.0}, {0.0, 1.0}}}};
  figure.curves[0].width_px = 6.0;
  VERIFY_OK(writeSvg(figure, folder.path("a.svg"), 400, 300));
  VERIFY_OK(pngCanBeWritten());
  VERIFY_OK(convertToPng(folder.path("a.svg"), folder.path("a.png"), 2.0));
  const QImage image(QString::fromStdString(folder.path("a.png")));
  QCOMPARE(image.size(), QSize(800, 600));
  QCOMPARE(image.pixelColor(2, 2), QColor(Qt::white));
  const QColor wanted(QString::fromStdString(colourOf(0)));
  int drawn = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) drawn += image.pixelColor(x, y) == wanted ? 1 : 0;
  }
  QVERIFY2(drawn > 1000 && drawn < 40000, qPrintable(QString::number(drawn)));
}

void TestPng::brokenPicture_leavesNothing() {
  test::TemporaryFolder folder;
  const std::string svg = folder.write("b.svg", "<svg");
  VERIFY_ERROR(convertToPng(svg, folder.path("b.png")), svg + ": cannot be drawn as PNG by rsvg-convert");
  QCOMPARE(folder.names(), QStringList{"b.svg"});
}

void TestPng::missingProgram_isNamed() {
  test::TemporaryFolder folder;
  const QByteArray path = qgetenv("PATH");
  qputenv("PATH", QByteArray::fromStdString(folder.path()));
  const auto able = pngCanBeWritten();
  qputenv("PATH", path);
  QVERIFY(!able.ok());
  QVERIFY2(able.error().message().find("librsvg2-bin") != std::string::npos, able.error().message().c_str());
}

QTEST_APPLESS_MAIN(TestPng)
#include "tst_png.moc"

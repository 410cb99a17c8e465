#include "base/made.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>
#include <thread>

#include "base/atomic_file.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestMade : public QObject {
  Q_OBJECT
 private slots:
  void withoutARun_nothingIsNoted();
  void hash_isThatOfTheStandard();
  void words_comeBackFromAShell();
  void readFiles_areInputsOnce();
  void jobsOfTheirOwn_haveInputsOfTheirOwn();
  void objects_getTheirMadeAtTheEnd_data();
  void objects_getTheirMadeAtTheEnd();
  void pictures_andPages_stayWhole();
};

static QJsonObject made() {
  return QJsonDocument::fromJson(QByteArray::fromStdString(madeJson())).object();
}

void TestMade::withoutARun_nothingIsNoted() {  // must come first
  noteInput("a", "b");
  noteDevice(MadeOn{"board", "", ""});
  noteRigTime(1.0);
  QCOMPARE(thisRun().inputs.size(), size_t(0));
  QVERIFY(!thisRun().device && !thisRun().rigTime_s);
  QVERIFY(made()["command"].isNull() && made()["seed"].isNull());
}

void TestMade::hash_isThatOfTheStandard() {  // FIPS 180-4's examples
  QCOMPARE(sha256Of("abc"), std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
  QCOMPARE(sha256Of(""), std::string("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"));
}

void TestMade::words_comeBackFromAShell() {
  QCOMPARE(asCommand({"breakaway", "fit", "--out", "m.json"}), std::string("breakaway fit --out m.json"));
  QCOMPARE(asCommand({"a b", "", "it's", "$HOME"}), std::string("'a b' '' 'it'\\''s' '$HOME'"));
}

void TestMade::readFiles_areInputsOnce() {
  const TemporaryFolder folder;
  const std::string path = folder.write("r.csv", "abc");
  beginRun("breakaway 1", "breakaway x", 7);
  const std::string first = thisRun().run;
  QVERIFY(readFile(path) && readFile(path));
  noteDevice(MadeOn{"a board", "", "3.1"});
  noteRigTime(2.5);
  QCOMPARE(thisRun().inputs, (std::vector<InputFile>{{path, sha256Of("abc")}}));
  QCOMPARE(made()["seed"].toInt(), 7);
  QCOMPARE(made()["by"].toString(), "breakaway 1");
  QCOMPARE(made()["rig_time_s"].toDouble(), 2.5);
  QCOMPARE(made()["device"].toObject()["model"].toString(), "a board");
  QVERIFY(made()["device"].toObject()["serial_number"].isNull());
  const QRegularExpression utc("^\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ$");
  QVERIFY(utc.match(made()["at"].toString()).hasMatch());
  beginRun("breakaway 1", "breakaway x");
  QVERIFY(thisRun().inputs.empty() && !thisRun().seed);
  QVERIFY(thisRun().run != first);
}

void TestMade::jobsOfTheirOwn_haveInputsOfTheirOwn() {
  beginRun("breakaway 1", "breakaway batch");
  noteInput("list", "1");
  std::vector<InputFile> other;
  std::thread([&other] {
    const OwnInputs own;
    noteInput("b", "2");
    other = thisRun().inputs;
  }).join();
  QCOMPARE(other, (std::vector<InputFile>{{"b", sha256Of("2")}}));
  QCOMPARE(thisRun().inputs, (std::vector<InputFile>{{"list", sha256Of("1")}}));
}

void TestMade::objects_getTheirMadeAtTheEnd_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::newRow("one line") << QByteArray(R"({"a":{"b":1}})");
  QTest::newRow("spread") << QByteArray("{\n  \"a\": {\n    \"b\": 1\n  }\n}\n");
  QTest::newRow("empty") << QByteArray("{}");
}

void TestMade::objects_getTheirMadeAtTheEnd() {
  QFETCH(QByteArray, text);
  QJsonObject expected = QJsonDocument::fromJson(text).object();
  expected["made"] = made();
  const QByteArray stamped = QByteArray::fromStdString(withMade(text.toStdString()));
  QCOMPARE(QJsonDocument::fromJson(stamped).object(), expected);
  QCOMPARE(stamped.count('\n') > 0, text.contains('\n'));
}

void TestMade::pictures_andPages_stayWhole() {
  beginRun("breakaway 1", asCommand({"breakaway", "</script><b>&"}));
  QXmlStreamReader svg(QString::fromStdString(svgWithMade("<svg><title>a</title></svg>")));
  QString metadata;
  while (!svg.atEnd()) {
    if (svg.readNext() == QXmlStreamReader::StartElement && svg.name() == QLatin1String("metadata"))
      metadata = svg.readElementText();
  }
  QVERIFY2(!svg.hasError(), qPrintable(svg.errorString()));
  QCOMPARE(QJsonDocument::fromJson(metadata.toUtf8()).object(), made());
  const QString html = QString::fromStdString(htmlOfMade());
  QVERIFY(!html.contains("<b>") && !html.contains("script>"));
  QXmlStreamReader page("<p>" + html + "</p>");
  QString inside;
  while (!page.atEnd()) {
    if (page.readNext() == QXmlStreamReader::StartElement && page.name() == QLatin1String("pre"))
      inside = page.readElementText();
  }
  QVERIFY2(!page.hasError(), qPrintable(page.errorString()));
  QCOMPARE(QJsonDocument::fromJson(inside.toUtf8()).object(), made());
}

QTEST_APPLESS_MAIN(TestMade)
#include "tst_made.moc"

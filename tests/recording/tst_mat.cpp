#include <matio.h>

#include <QTest>
#include <memory>

#include "recording/import/mat.h"
#include "recording/import/read_table.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

namespace {

template <typename T>
void add(mat_t* file, const char* name, matio_classes kind, matio_types type, std::vector<T> values, size_t rows,
         matio_compression packing) {
  size_t dims[2] = {rows, values.size() / rows};
  matvar_t* variable = Mat_VarCreate(name, kind, type, 2, dims, values.data(), 0);
  QVERIFY(Mat_VarWrite(file, variable, packing) == 0);
  Mat_VarFree(variable);
}

void addStruct(mat_t* file) {
  const char* fields[] = {"time", "label"};
  size_t one[2] = {1, 1}, three[2] = {1, 3};
  double times[] = {7, 8, 9};
  char text[] = "abc";
  matvar_t* variable = Mat_VarCreateStruct("log", 2, one, fields, 2);
  Mat_VarSetStructFieldByName(variable, "time", 0,
                              Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, three, times, 0));
  Mat_VarSetStructFieldByName(variable, "label", 0, Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT8, 2, three, text, 0));
  Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE);
  Mat_VarFree(variable);
}

/// A file with all that readMat is to understand; the vector `t` has 1000 values.
void writeSample(const std::string& path, mat_ft version, matio_compression packing) {
  mat_t* file = Mat_CreateVer(path.c_str(), nullptr, version);
  QVERIFY(file != nullptr);
  std::vector<double> t(1000);
  for (size_t k = 0; k < t.size(); ++k) t[k] = 1e-3 * static_cast<double>(k);
  add<double>(file, "t", MAT_C_DOUBLE, MAT_T_DOUBLE, t, 1000, packing);
  add<int16_t>(file, "counts", MAT_C_INT16, MAT_T_INT16, {-3, 0, 32767}, 1, packing);
  add<float>(file, "gain", MAT_C_SINGLE, MAT_T_SINGLE, {0.5F}, 1, packing);
  add<double>(file, "both", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 2, 3, 4, 5, 6}, 3, packing);
  addStruct(file);
  Mat_Close(file);
}

}  // namespace

class TestMat : public QObject {
  Q_OBJECT
 private slots:
  void arraysOfEveryKind_areRead_data() { versions(); }
  void arraysOfEveryKind_areRead();
  void fromAStream_isATableToo_data() { versions(); }
  void fromAStream_isATableToo();
  void fileCutAnywhere_isOneErrorAndNoCrash_data() { versions(); }
  void fileCutAnywhere_isOneErrorAndNoCrash();
  void changedBytes_neverCrash_data() { versions(); }
  void changedBytes_neverCrash();
  void packedVariableThatOneBitChanges_isRefused();
  void otherFiles_areRefused();

 private:
  static void versions() {
    QTest::addColumn<int>("version");
    QTest::addColumn<int>("packing");
    QTest::newRow("5") << int(MAT_FT_MAT5) << int(MAT_COMPRESSION_NONE);
    QTest::newRow("5, compressed") << int(MAT_FT_MAT5) << int(MAT_COMPRESSION_ZLIB);
    QTest::newRow("7.3") << int(MAT_FT_MAT73) << int(MAT_COMPRESSION_NONE);
    QTest::newRow("7.3, compressed") << int(MAT_FT_MAT73) << int(MAT_COMPRESSION_ZLIB);
  }
  std::string sample() const {
    QFETCH(int, version);
    QFETCH(int, packing);
    writeSample(folder_.path("s.mat"), mat_ft(version), matio_compression(packing));
    return folder_.path("s.mat");
  }
  TemporaryFolder folder_;
};

void TestMat::arraysOfEveryKind_areRead() {
  const auto channels = readMat(*readFile(sample()), "s.mat");
  VERIFY_OK(channels);
  const auto values = [&channels](const std::string& name) {
    for (const Channel& one : *channels) {
      if (one.name == name) return one.values;
    }
    return std::vector<double>{};
  };
  QCOMPARE(values("t").size(), size_t(1000));
  QCOMPARE(values("t")[999], 0.999);
  QCOMPARE(values("counts"), (std::vector<double>{-3, 0, 32767}));
  QCOMPARE(values("gain"), (std::vector<double>{0.5}));
  QCOMPARE(values("both_1"), (std::vector<double>{1, 2, 3}));
  QCOMPARE(values("both_2"), (std::vector<double>{4, 5, 6}));
  QCOMPARE(values("log.time"), (std::vector<double>{7, 8, 9}));
  QCOMPARE(channels->size(), size_t(6));
}

/// As from standard input: there is no path to read again.
void TestMat::fromAStream_isATableToo() {
  const auto read = readTableBytes(std::string(*readFile(sample())), "-");
  VERIFY_OK(read);
  QCOMPARE(read->table.columns.size(), size_t(1));
  QCOMPARE(read->table.columns.front().channel.name, std::string("t"));
  QCOMPARE(read->table.rows(), size_t(1000));
}

void TestMat::fileCutAnywhere_isOneErrorAndNoCrash() {
  const std::string whole = *readFile(sample());
  for (const double part : {0.0, 0.004, 0.02, 0.1, 0.3, 0.5, 0.8, 0.95, 0.999}) {
    const auto size = static_cast<size_t>(part * static_cast<double>(whole.size()));
    const auto read = readMat(whole.substr(0, size), "cut.mat");
    const bool nothingYet = size == 128;  // a header and no variable
    QVERIFY2(!read.ok(), qPrintable(QString("cut to %1 of %2 bytes").arg(size).arg(whole.size())));
    QVERIFY(read.error().message().find('\n') == std::string::npos);
    QVERIFY2(nothingYet || read.error().place == "cut.mat", read.error().message().c_str());
  }
}

void TestMat::changedBytes_neverCrash() {
  const std::string whole = *readFile(sample());
  unsigned state = 12345;
  for (int run = 0; run < 60; ++run) {
    std::string bytes = whole;
    for (int k = 0; k < 20; ++k) {
      state = state * 1664525U + 1013904223U;
      bytes[(state >> 8) % bytes.size()] = static_cast<char>(state >> 3);
    }
    const auto read = readMat(bytes, "changed.mat");
    if (!read) QVERIFY(read.error().message().find('\n') == std::string::npos);
  }
}

/// Where the library's own reading goes on, with other values.
void TestMat::packedVariableThatOneBitChanges_isRefused() {
  const std::string path = folder_.path("packed.mat");
  writeSample(path, MAT_FT_MAT5, MAT_COMPRESSION_ZLIB);
  const std::string whole = *readFile(path);
  const size_t size = static_cast<unsigned char>(whole[132]) + 256U * static_cast<unsigned char>(whole[133]);
  QCOMPARE(whole[128], char(15));
  for (const size_t at : {size_t{136} + size / 3, size_t{136} + size / 2, size_t{135} + size}) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    VERIFY_ERROR(readMat(bytes, "a.mat"), "a.mat: is damaged: the variable at byte 128 can't be unpacked");
  }
}

void TestMat::otherFiles_areRefused() {
  VERIFY_ERROR(readMat("time_s,angle_rad\n0,1\n", "a.mat"), "a.mat: is no MATLAB file of version 5 or 7.3");
  VERIFY_ERROR(readMat("", "a.mat"), "a.mat: is empty, expected a MATLAB file");
}

QTEST_APPLESS_MAIN(TestMat)
#include "tst_mat.moc"

#include <unistd.h>
#include <QTest>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "base/contained.h"
#include "support/temporary.h"

using namespace breakaway;

class TestContained : public QObject {
  Q_OBJECT
 private slots:
  void bytes_comeBackWhole();
  void whateverEndsTheWork_isOneError_data();
  void whateverEndsTheWork_isOneError();
};

void TestContained::bytes_comeBackWhole() {
  std::string bytes(3'000'000, '\0');
  for (size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<char>(k * 31);
  const auto got = runContained(
      [&bytes] {
        std::printf("not to be seen\n");
        return bytes;
      },
      "f");
  VERIFY_OK(got);
  QVERIFY(*got == bytes);
  QCOMPARE(*runContained([] { return std::string(); }, "f"), std::string());
}

void TestContained::whateverEndsTheWork_isOneError_data() {
  QTest::addColumn<int>("how");
  QTest::newRow("abort") << 0;
  QTest::newRow("kill") << 1;
  QTest::newRow("exception") << 2;
  QTest::newRow("exit") << 3;
  QTest::newRow("endless computing") << 4;
  QTest::newRow("endless waiting") << 5;
  QTest::newRow("a handler that waits") << 6;
}

void TestContained::whateverEndsTheWork_isOneError() {
  QFETCH(int, how);
  const auto work = [how]() -> std::string {
    if (how == 0) std::abort();
    if (how == 1) std::raise(SIGKILL);
    if (how == 2) throw std::runtime_error("no");
    if (how == 3) std::_Exit(0);
    if (how == 5) {
      while (true) ::pause();
    }
    if (how == 6) std::raise(SIGSEGV);
    volatile bool spinning = true;
    while (spinning) {
    }
    return {};
  };
  const auto before = std::signal(SIGSEGV, [](int) {
    while (true) ::pause();
  });
  const auto got = runContained(work, "f", {.computing_s = 1});
  std::signal(SIGSEGV, before);
  VERIFY_ERROR(got, "f: is damaged, reading it ended early");
}

QTEST_APPLESS_MAIN(TestContained)
#include "tst_contained.moc"

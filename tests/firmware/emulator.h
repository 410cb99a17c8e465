// The emulated Cortex-M3 board as a process: started, found by its pty, ended.
#pragma once

#include <sched.h>

#include <QElapsedTimer>
#include <QProcess>
#include <QRegularExpression>
#include <QString>
#include <string>

namespace breakaway::test {

class Emulator {
 public:
  explicit Emulator(const std::string& image, const QStringList& line = {"-serial", "pty"}) {
    process_.setProcessChannelMode(QProcess::MergedChannels);
    // Its processor and its input hand over to each other at every byte, which two cores only hold up.
    process_.setChildProcessModifier([] {
      cpu_set_t all, last;
      CPU_ZERO(&last);
      if (::sched_getaffinity(0, sizeof all, &all) != 0) return;
      int cpu = CPU_SETSIZE - 1;
      while (cpu > 0 && !CPU_ISSET(cpu, &all)) --cpu;
      CPU_SET(cpu, &last);
      ::sched_setaffinity(0, sizeof last, &last);
    });
    process_.start("qemu-system-arm", QStringList{"-M", "mps2-an385", "-nographic", "-monitor", "none", "-kernel",
                                                  QString::fromStdString(image)} +
                                          line);
    static const QRegularExpression named("/dev/pts/[0-9]+");
    QElapsedTimer waited;
    waited.start();
    while (port_.empty() && waited.elapsed() < 20000 && process_.state() != QProcess::NotRunning) {
      process_.waitForReadyRead(100);
      said_ += QString::fromLocal8Bit(process_.readAll());
      port_ = named.match(said_).captured(0).toStdString();
    }
  }
  /// How emulated_board_quick.elf is connected: it hears by the serial port and speaks by the emulator's console, both
  /// at one pty. The key that would speak to the emulator itself is put where no byte is.
  static QStringList byConsole() {
    return {"-chardev",
            "pty,id=wire,mux=on",
            "-serial",
            "chardev:wire",
            "-semihosting-config",
            "enable=on,target=native,chardev=wire",
            "-echr",
            "0x100"};
  }
  ~Emulator() {
    process_.kill();
    process_.waitForFinished(5000);
  }
  Emulator(const Emulator&) = delete;
  Emulator& operator=(const Emulator&) = delete;

  bool runs() const { return !port_.empty(); }
  std::string uri() const { return "serial:" + port_; }
  QString said() const { return said_; }

 private:
  QProcess process_;
  QString said_;
  std::string port_;
};

}  // namespace breakaway::test

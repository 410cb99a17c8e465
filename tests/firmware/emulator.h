// The emulated Cortex-M3 board as a process: started, found by its pty, ended.
#pragma once

#include <QElapsedTimer>
#include <QProcess>
#include <QRegularExpression>
#include <QString>
#include <string>

namespace breakaway::test {

class Emulator {
 public:
  explicit Emulator(const std::string& image, const QStringList& further = {}) {
    process_.setProcessChannelMode(QProcess::MergedChannels);
    process_.start("qemu-system-arm", QStringList{"-M", "mps2-an385", "-nographic", "-monitor", "none", "-serial",
                                                  "pty", "-kernel", QString::fromStdString(image)} +
                                          further);
    static const QRegularExpression named("/dev/pts/[0-9]+");
    QElapsedTimer waited;
    waited.start();
    while (port_.empty() && waited.elapsed() < 20000 && process_.state() != QProcess::NotRunning) {
      process_.waitForReadyRead(100);
      said_ += QString::fromLocal8Bit(process_.readAll());
      port_ = named.match(said_).captured(0).toStdString();
    }
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

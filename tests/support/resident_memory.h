// How much memory a process holds.
#pragma once

#include <QFile>

namespace breakaway::test {

/// Resident memory in MB; 0 when the system doesn't tell.
inline double resident_MB(qint64 process) {
  QFile file(QString("/proc/%1/status").arg(process));
  if (!file.open(QIODevice::ReadOnly)) return 0.0;
  for (const QByteArray& line : file.readAll().split('\n')) {
    if (line.startsWith("VmRSS:")) return 1e-3 * line.mid(6).trimmed().split(' ').front().toDouble();
  }
  return 0.0;
}

}  // namespace breakaway::test

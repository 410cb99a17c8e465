// A mass that is pushed to and fro, as files: small input for the real program.
#pragma once

#include <QByteArray>
#include <cmath>

namespace breakaway::test {

inline QByteArray pushedMassBench(const char* motor = R"("mass_kg": 95)") {
  return QByteArray(R"({"schema": "breakaway.bench/1", "axis": "linear", "drive": {"input": "force_N"}, "motor": {)") +
         motor + "}}";
}

/// Rows of a mass that is pushed to and fro, `position` in place of row 100's position.
inline QByteArray pushedMassRecording(int rows = 5000, const QByteArray& position = {},
                                      const QByteArray& header = "time_s,position_m,force_N", double step_s = 1e-3) {
  QByteArray text = header + "\n";
  for (int k = 0; k < rows; ++k) {
    const double t = step_s * k, x = 0.01 * std::sin(6.0 * t),
                 force = -95.0 * 0.36 * std::sin(6.0 * t) + 20.0 * (std::cos(6.0 * t) > 0 ? 1 : -1);
    text += QByteArray::number(t) + "," + (k == 99 && !position.isEmpty() ? position : QByteArray::number(x, 'g', 9)) +
            "," + QByteArray::number(force, 'g', 9) + "\n";
  }
  return text;
}

/// A mass that is pushed to and fro against a constant load: soon diagnosed, and something is missing.
inline QByteArray loadedMassRecording() {
  QByteArray text = "time_s,position_m,force_N\n";
  for (int k = 0; k < 400; ++k) {
    const double t = 0.02 * k, friction_N = std::cos(6.0 * t) > 0.0 ? 20.0 : -20.0;
    text += QByteArray::number(t) + "," + QByteArray::number(0.01 * std::sin(6.0 * t), 'g', 9) + "," +
            QByteArray::number(15.0 + friction_N - 34.2 * std::sin(6.0 * t), 'g', 9) + "\n";
  }
  return text;
}

}  // namespace breakaway::test

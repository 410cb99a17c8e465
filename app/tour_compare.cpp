// The tour's stations on Compare: the example, another tool's log, a sealed trial.
#include <QAbstractButton>
#include <QComboBox>
#include <QFile>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>

#include "session/resource_folder.h"
#include "tour.h"

namespace breakaway {

void Tour::compare() {
  window_.showPage("comparePage");
  shoot("compare-empty");
  if (resourceFiles("examples", ".bench.json").isEmpty()) return;
  press("openExampleButton");
  if (!wait([this] { return session_.comparison.bench() && session_.comparison.recording(); }))
    trouble_ = "the example cannot be opened";
  shoot("compare-opened");
  openLog();
  press("diagnoseButton");
  shoot("compare-running");
  if (!wait([this] {
        return !session_.comparison.shownTrace().position.empty() && !session_.comparison.baseTrace().position.empty();
      })) {
    trouble_ = "the diagnosis did not end";
    return;
  }
  if (!wait([this] { return !session_.comparison.evidenceIsComing(); })) trouble_ = "the evidence doesn't come";
  shoot("compare-diagnosed");
  if (session_.comparison.diagnosis()->where.empty()) return;
  auto* axis = window_.findChild<QComboBox*>("residualAxis");
  window_.findChild<QWidget*>("comparePage")->setFocus();
  axis->setCurrentIndex(
      std::max(0, axis->findData(QString::fromStdString(session_.comparison.diagnosis()->where.front().axis))));
  if (auto* motion = window_.findChild<QAbstractButton*>("showMotion")) motion->click();
  shoot("compare-where");
  axis->setCurrentIndex(0);
  overlay();
}

/// The same drive on a rotor that comes 6 % further, recorded half a second earlier.
void Tour::overlay() {
  const auto& recording = session_.comparison.recording();
  const QTemporaryDir folder;
  QFile other(folder.filePath("before greasing.csv"));
  if (!other.open(QIODevice::WriteOnly)) return;
  other.write("time_s,angle_rad\n");
  const auto time = recording->time(), angle = recording->channel("angle_rad");
  constexpr size_t every = 10;
  for (size_t row = 0; row < time.size(); row += every)
    other.write(QString("%1,%2\n").arg(time[row] + 0.5, 0, 'f', 4).arg(1.06 * angle[row], 0, 'f', 5).toUtf8());
  other.close();
  session_.comparison.layBeneath(other.fileName());
  if (!wait([this] { return session_.comparison.beneath().has_value(); }, 20'000)) trouble_ = "nothing lies beneath";
  shoot("compare-overlay");
  session_.comparison.layBeneath({});
}

/// Where the command that conceals is beside this one.
void Tour::sealedTrial() {
  constexpr unsigned seed = 34;
  TrialRun& trial = session_.trial;
  if (!trial.obstacle().isEmpty()) return;
  window_.showPage("comparePage");
  trial.conceal(seed);
  if (!wait([&] { return trial.isOpen() && session_.comparison.recording(); })) {
    trouble_ = "the trial was not recorded";
    return;
  }
  shoot("compare-sealed");
  press("diagnoseButton");
  if (!wait([&] { return trial.sealObstacle().isEmpty() && !session_.comparison.shownTrace().position.empty(); })) {
    trouble_ = "the trial's diagnosis did not end";
    return;
  }
  press("unsealButton");
  shoot("compare-unsealed");
}

/// Another tool's log, as it is understood before it is opened.
void Tour::openLog() {
  const QTemporaryDir folder;
  QFile log(folder.filePath("bench 3, run 7.csv"));
  if (!log.open(QIODevice::WriteOnly)) return;
  log.write("t [ms];Winkel [°];Drehzahl [1/min];iq;u;board temp\n");
  for (int k = 0; k < 200; ++k) {
    const double t = 0.01 * k, angle = 400.0 * (1.0 - std::cos(3.0 * t)), speed = 1200.0 * std::sin(3.0 * t);
    log.write(QString("%1;%2;%3;%4;%5;%6\n")
                  .arg(10 * k)
                  .arg(angle)
                  .arg(speed / 6.0)
                  .arg(0.3 * std::cos(3.0 * t))
                  .arg(6.0 * std::sin(3.0 * t))
                  .arg(31.5)
                  .toUtf8());
  }
  log.close();
  files_.path = log.fileName();
  press("openRecordingButton");
  if (!wait([this] { return session_.comparison.log().isOpen() && !session_.comparison.log().settling(); }, 5000))
    trouble_ = "the log cannot be opened";
  shoot("compare-log");
  press("logCloseButton");
  files_.path.clear();
}

}  // namespace breakaway

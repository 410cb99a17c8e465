#include "session/comparison.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "recording/block_file.h"
#include "recording/columns.h"
#include "session/language.h"

namespace breakaway {

Comparison::Comparison(Messages& messages, QObject* parent) : QObject(parent), messages_(messages), log_(messages) {
  pool_.setMaxThreadCount(2);
  connect(&log_, &LogOpening::accepted, this, [this](const Recording& recording) {
    take(logged_, recording);
    forgetDiagnosis();
  });
}

Comparison::~Comparison() {
  stop_.request_stop();
  pool_.waitForDone();
}

void Comparison::inPool(std::function<std::function<void()>()> work) {
  pool_.start([this, work = std::move(work)] { QMetaObject::invokeMethod(this, work(), Qt::QueuedConnection); });
}

void Comparison::open(const QString& path) {
  path.endsWith(".json") ? openBench(path) : openRecording(path);
}

void Comparison::openBench(const QString& path) {
  const auto bench = readBench(path.toStdString());
  if (!bench) {
    messages_.warn(bench.error());
    return;
  }
  bench_ = *bench;
  forgetDiagnosis();
}

void Comparison::openRecording(const QString& path) {
  read(path, &Comparison::recording_);
}

void Comparison::openHeldout(const QString& path) {
  read(path, &Comparison::heldout_);
}

void Comparison::takeRecording(const Recording& recording) {
  take(&Comparison::recording_, recording);
  forgetDiagnosis();
}

void Comparison::takeBench(const Bench& bench) {
  bench_ = bench;
  forgetDiagnosis();
}

std::vector<Recording> Comparison::together(const std::optional<Recording>& first,
                                            const std::vector<Recording>& others) {
  std::vector<Recording> all;
  if (first) all.push_back(*first);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

/// One that is opened alone replaces all of its kind.
void Comparison::take(std::optional<Recording> Comparison::*into, const Recording& recording) {
  this->*into = recording;
  (into == &Comparison::heldout_ ? heldoutBeside_ : beside_).clear();
}

void Comparison::openTogether(const ComparedFiles& files) {
  log_.close();
  inPool([this, files]() -> std::function<void()> {
    const auto readAll = [](const QStringList& paths) -> Result<std::vector<Recording>> {
      std::vector<Recording> all;
      for (const QString& path : paths) {
        auto recording = readRecording(path.toStdString());
        if (!recording) return recording.error();
        all.push_back(std::move(*recording));
      }
      return all;
    };
    const auto bench = readBench(files.bench.toStdString());
    const auto recordings = readAll(files.recordings), heldout = readAll(files.heldout);
    return [this, bench, recordings, heldout] {
      if (!bench) return messages_.warn(bench.error());
      if (!recordings) return messages_.warn(recordings.error());
      if (!heldout) return messages_.warn(heldout.error());
      const auto split = [](const std::vector<Recording>& all, std::optional<Recording>& first) {
        first = all.empty() ? std::nullopt : std::optional(all.front());
        return all.empty() ? all : std::vector<Recording>(all.begin() + 1, all.end());
      };
      bench_ = *bench;
      beside_ = split(*recordings, recording_);
      heldoutBeside_ = split(*heldout, heldout_);
      forgetDiagnosis();
    };
  });
}

void Comparison::read(const QString& path, std::optional<Recording> Comparison::*into) {
  log_.close();
  if (!LogOpening::isRecording(path)) {
    logged_ = into;
    log_.open(path);
    return;
  }
  inPool([this, path, into]() -> std::function<void()> {
    auto recording = readRecording(path.toStdString());
    return [this, recording, path, into] {
      if (!recording) {
        messages_.warn(recording.error());
        return;
      }
      take(into, *recording);
      messages_.say(tr("%1: %2 rows").arg(QFileInfo(path).fileName()).arg(recording->rows()));
      takeBenchBeside(path);
      forgetDiagnosis();
    };
  });
}

void Comparison::layBeneath(const QString& path, const QString& name) {
  const unsigned mine = ++wantedBeneath_;
  if (path.isEmpty()) {
    beneath_.reset();
    emit beneathChanged();
    return;
  }
  inPool([this, path, name, mine]() -> std::function<void()> {
    const auto recording = readRecording(path.toStdString());
    BeneathRecording read{name.isEmpty() ? QFileInfo(path).fileName() : name, nullptr};
    if (recording) {
      read.linear = recording->has("position_m");
      const std::string channel = columnName(Quantity::position, read.linear ? Axis::linear : Axis::rotary);
      const auto position = recording->channel(channel);
      if (!position.empty()) read.overview = std::make_shared<const Overview>(*recording, channel);
    }
    return [this, mine, recording, read] {
      if (mine != wantedBeneath_) return;
      if (!recording) return messages_.warn(recording.error());
      if (!read.overview) return messages_.warn(tr("%1 holds no position to lay beneath").arg(read.name));
      beneath_ = read;
      emit beneathChanged();
    };
  });
}

/// Where no bench is open, and only one can be meant.
void Comparison::takeBenchBeside(const QString& path) {
  const QDir folder = QFileInfo(path).dir();
  const QStringList names = folder.entryList({"*.bench.json"}, QDir::Files);
  if (bench_ || names.size() != 1) return;
  const auto bench = readBench(folder.filePath(names.front()).toStdString());
  if (!bench) return;
  bench_ = *bench;
  messages_.say(tr("%1 lies beside the recording and was opened with it").arg(names.front()));
}

void Comparison::forgetDiagnosis() {
  cancel();
  ++wanted_;
  diagnosis_.reset();
  mended_.reset();
  leftOut_.clear();
  base_ = shown_ = {};
  torque_.reset();
  evidences_.clear();
  evidence_ = 0;
  evidenceComes_ = false;
  prepareOverview();
  emit inputsChanged();
  emit diagnosisChanged();
  emit tracesChanged();
  emit evidenceChanged();
}

void Comparison::prepareOverview() {
  const unsigned mine = ++wantedOverview_;
  overview_.reset();
  if (!recording()) return;
  inPool([this, mine, recording = *recording()]() -> std::function<void()> {
    const auto overview =
        std::make_shared<const Overview>(recording, recording.has("position_m") ? "position_m" : "angle_rad");
    return [this, mine, overview] {
      if (mine != wantedOverview_) return;
      overview_ = overview;
      emit overviewChanged();
    };
  });
}

QString Comparison::obstacle() const {
  if (diagnosing_) return tr("A diagnosis is running");
  if (!bench_ && !recording_) return tr("Open a bench and a recording first");
  if (!bench_) return tr("Open the recording's bench first");
  if (!recording_) return tr("Open a recording first");
  return {};
}

void Comparison::diagnose() {
  if (!obstacle().isEmpty()) return;
  forgetDiagnosis();
  stop_ = {};
  time_ = TimeLimit();
  diagnosing_ = true;
  progress_ = 0.0;
  activity_ = tr("starting");
  const unsigned mine = wanted_;
  DiagnoseOptions options;
  options.stop = stop_.get_token();
  options.time = time_;
  options.progress = [this, mine](double progress, const Message& activity) {
    QMetaObject::invokeMethod(
        this,
        [this, mine, progress, activity] {
          if (mine != wanted_ || !diagnosing_) return;
          progress_ = progress;
          activity_ = inLanguage(activity);
          emit progressChanged();
        },
        Qt::QueuedConnection);
  };
  inPool([this, mine, options, bench = *bench_, recordings = together(recording_, beside_),
          heldout = allHeldout()]() -> std::function<void()> {
    const auto diagnosis = breakaway::diagnose(bench, recordings, heldout, options);
    return [this, mine, diagnosis] {
      if (mine == wanted_) takeDiagnosis(diagnosis);
    };
  });
  emit progressChanged();
}

void Comparison::cancel() {
  if (!diagnosing_) return;
  stop_.request_stop();
  ++wanted_;
  diagnosing_ = false;
  emit progressChanged();
}

void Comparison::finishNow() {
  time_.end();
  emit progressChanged();
}

void Comparison::takeDiagnosis(const Result<Diagnosis>& diagnosis) {
  diagnosing_ = false;
  emit progressChanged();
  if (!diagnosis) {
    messages_.warn(diagnosis.error());
    return;
  }
  diagnosis_ = *diagnosis;
  if (diagnosis_->misread) {
    mended_ = mended(*recording_, *diagnosis_->misread);
    prepareOverview();
  }
  evidenceComes_ = true;
  emit diagnosisChanged();
  simulateBase();
  simulateShown();
  gatherEvidence();
}

void Comparison::gatherEvidence() {
  const auto& misread = diagnosis_->misread;
  inPool([this, mine = wanted_, diagnosis = *diagnosis_, bench = misread ? mended(*bench_, *misread) : *bench_,
          recording = *recording(), heldout = heldout_]() -> std::function<void()> {
    const auto evidences = evidenceOf(diagnosis, bench, recording, heldout);
    return [this, mine, evidences] {
      if (mine != wanted_) return;
      evidences_ = evidences;
      evidence_ = 0;
      evidenceComes_ = false;
      emit evidenceChanged();
    };
  });
}

void Comparison::chooseEvidence(const std::string& effect) {
  const auto found = std::find_if(evidences_.begin(), evidences_.end(),
                                  [&effect](const Evidence& one) { return one.effect == effect; });
  if (found == evidences_.end()) return;
  evidence_ = static_cast<size_t>(found - evidences_.begin());
  emit evidenceChanged();
}

void Comparison::include(const std::string& effect, bool included) {
  if (includes(effect) == included) return;
  if (included) {
    leftOut_.erase(effect);
  } else {
    leftOut_.insert(effect);
  }
  simulateShown();
}

void Comparison::simulateBase() {
  inPool([this, mine = wanted_, diagnosis = *diagnosis_, recording = *recording()]() -> std::function<void()> {
    const auto trace = simulate(diagnosis.base, recording, {diagnosis.fit.window_s});
    return [this, mine, trace] {
      if (mine != wanted_ || !trace) return;
      base_ = *trace;
      emit tracesChanged();
    };
  });
}

void Comparison::simulateShown() {
  if (!diagnosis_) return;
  Model model = diagnosis_->model;
  std::erase_if(model.effects, [this](const EffectTerm& term) { return !includes(term.effect); });
  inPool([this, mine = wanted_, leftOut = leftOut_, diagnosis = *diagnosis_, model,
          recording = *recording()]() -> std::function<void()> {
    const auto trace = simulate(model, recording, {diagnosis.fit.window_s});
    const auto torque = torqueViewOf(diagnosis, model, recording);
    return [this, mine, leftOut, trace, torque] {
      if (mine != wanted_ || leftOut != leftOut_) return;
      if (!trace) {
        messages_.warn(trace.error());
        return;
      }
      shown_ = *trace;
      torque_ = torque;
      emit tracesChanged();
    };
  });
}

double Comparison::shownRmse() const {
  if (!diagnosis_ || !recording_) return 0.0;
  return positionRmse(shown_, *recording(), shownChannel(), diagnosis_->heldoutRows);
}

std::string Comparison::shownChannel() const {
  if (!diagnosis_) return {};
  return diagnosis_->fit.inTorque() ? columnName(Quantity::position, diagnosis_->model.axis) : diagnosis_->fit.channel;
}

double positionRmse(const Trace& trace, const Recording& recording, const std::string& channel,
                    const std::vector<std::pair<size_t, size_t>>& stretches) {
  const auto measured = recording.channel(channel);
  const auto& shown = channel.starts_with("velocity") ? trace.velocity : trace.position;
  const size_t rows = std::min(measured.size(), shown.size());
  const std::vector<std::pair<size_t, size_t>> all{{0, rows}};
  double sum = 0.0;
  size_t count = 0;
  for (const auto& [first, last] : stretches.empty() ? all : stretches) {
    for (size_t row = first; row < std::min(last, rows); ++row) {
      const double error = shown[row] - measured[row];
      if (!std::isfinite(error)) continue;
      sum += error * error;
      ++count;
    }
  }
  return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

}  // namespace breakaway

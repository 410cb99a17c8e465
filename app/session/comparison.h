// A recording against the physics its bench declares: loads, diagnoses in a pool thread, and simulates with findings
// left out.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "diagnose/diagnosis.h"
#include "diagnose/simulate/simulation.h"
#include "motor/bench.h"
#include "recording/recording.h"
#include "session/evidence.h"
#include "session/log_opening.h"
#include "session/messages.h"
#include "session/overview.h"
#include "session/torque_view.h"

namespace breakaway {

/// What is opened at once: several recordings are fitted together, the first is shown.
struct ComparedFiles {
  QString bench;
  QStringList recordings, heldout;
};

/// The position in a recording that lies beneath the one that is compared; both are laid over each other by their
/// beginnings.
struct BeneathRecording {
  QString name;
  std::shared_ptr<const Overview> overview;
  bool linear = false;
};

class Comparison : public QObject {
  Q_OBJECT

 public:
  explicit Comparison(Messages& messages, QObject* parent = nullptr);
  ~Comparison() override;

  void openBench(const QString& path);
  /// Reads in a pool thread; another tool's log is understood first, in log(). Without a held-out recording, blocks of
  /// the recording itself are held out. Where no bench is open, the only bench file beside the recording is opened,
  /// too.
  void openRecording(const QString& path);
  void openHeldout(const QString& path);
  /// All of them or none.
  void openTogether(const ComparedFiles& files);
  void takeRecording(const Recording& recording);
  void takeBench(const Bench& bench);
  /// Reads one of ours, CSV or blocks, in a pool thread; without a name it is called as its file. An empty path takes
  /// what lies there away.
  void layBeneath(const QString& path, const QString& name = {});
  /// A bench if the name ends in .json, a recording otherwise.
  void open(const QString& path);

  LogOpening& log() { return log_; }

  void diagnose();
  void cancel();
  /// What was found so far is weighed and proved, and that is the answer.
  void finishNow();
  /// Whether it was asked to.
  bool finishing() const { return diagnosing_ && time_.over(); }
  /// Whether the effect takes part in the simulation that is shown.
  void include(const std::string& effect, bool included);
  bool includes(const std::string& effect) const { return !leftOut_.contains(effect); }

  const std::optional<Bench>& bench() const { return bench_; }
  /// What is shown: after a diagnosis that found a column misread, with that put right.
  const std::optional<Recording>& recording() const { return mended_ ? mended_ : recording_; }
  /// The position in recording(), ready to be drawn at any zoom; it comes a little after the recording.
  const std::shared_ptr<const Overview>& overview() const { return overview_; }
  const std::optional<BeneathRecording>& beneath() const { return beneath_; }
  const std::optional<Recording>& heldout() const { return heldout_; }
  /// All that a diagnosis takes, the first of each as above.
  std::vector<Recording> recordings() const { return together(recording(), beside_); }
  std::vector<Recording> allHeldout() const { return together(heldout_, heldoutBeside_); }
  const std::optional<Diagnosis>& diagnosis() const { return diagnosis_; }
  bool diagnosing() const { return diagnosing_; }
  double progress() const { return progress_; }
  const QString& activity() const { return activity_; }
  /// Why diagnose() can't run now; empty when it can.
  QString obstacle() const;

  /// Simulation of the base model, and of the extended one with the findings that are included; empty before a
  /// diagnosis.
  const Trace& baseTrace() const { return base_; }
  const Trace& shownTrace() const { return shown_; }
  /// What both leave of the torque, where that counts; it comes with shownTrace().
  const std::optional<TorqueView>& torque() const { return torque_; }
  /// A diagnosis is there, and what unseen data show of it isn't yet.
  bool evidenceIsComing() const { return evidenceComes_; }
  /// Of the finding that was chosen, the first one at the beginning; it comes a little after the diagnosis.
  const Evidence* evidence() const { return evidence_ < evidences_.size() ? &evidences_[evidence_] : nullptr; }
  /// One for each finding that has an axis of its own.
  const std::vector<Evidence>& evidences() const { return evidences_; }
  void chooseEvidence(const std::string& effect);
  /// RMS of the shown simulation's position error over the held-out rows, or over all rows if those held out are of
  /// another recording.
  double shownRmse() const;
  std::string shownChannel() const;  ///< in which; empty without a diagnosis

 signals:
  void inputsChanged();
  void overviewChanged();
  void beneathChanged();
  void progressChanged();
  void diagnosisChanged();
  void tracesChanged();
  void evidenceChanged();

 private:
  static std::vector<Recording> together(const std::optional<Recording>& first, const std::vector<Recording>& others);
  void inPool(std::function<std::function<void()>()> work);
  void take(std::optional<Recording> Comparison::*into, const Recording& recording);
  void read(const QString& path, std::optional<Recording> Comparison::*into);
  void takeBenchBeside(const QString& path);
  void forgetDiagnosis();
  void prepareOverview();
  void takeDiagnosis(const Result<Diagnosis>& diagnosis);
  void simulateBase();
  void simulateShown();
  void gatherEvidence();

  Messages& messages_;
  LogOpening log_;
  std::optional<Recording> Comparison::*logged_ = nullptr;  ///< where the log goes
  QThreadPool pool_;
  std::stop_source stop_;
  TimeLimit time_;
  std::optional<Bench> bench_;
  std::optional<Recording> recording_, mended_;
  std::optional<Recording> heldout_;
  std::vector<Recording> beside_, heldoutBeside_;  ///< further ones that were opened together
  std::optional<Diagnosis> diagnosis_;
  std::set<std::string> leftOut_;
  std::shared_ptr<const Overview> overview_;
  unsigned wantedOverview_ = 0;  ///< number of the newest
  std::optional<BeneathRecording> beneath_;
  unsigned wantedBeneath_ = 0;
  Trace base_, shown_;
  std::optional<TorqueView> torque_;
  std::vector<Evidence> evidences_;
  size_t evidence_ = 0;  ///< which of them is chosen
  bool evidenceComes_ = false;
  unsigned wanted_ = 0;  ///< number of the newest simulation or diagnosis asked for; older answers are not shown
  bool diagnosing_ = false;
  double progress_ = 0.0;
  QString activity_;
};

/// RMS of simulated minus measured position over the stretches [first, last) of rows, or over all rows if there is no
/// stretch.
double positionRmse(const Trace& trace, const Recording& recording, const std::string& channel,
                    const std::vector<std::pair<size_t, size_t>>& stretches);

}  // namespace breakaway

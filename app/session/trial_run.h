// A sealed trial: the command conceals physics in a simulated rig and records it; this window sees the files alone
// until it has diagnosed them.
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QTemporaryDir>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/verdict/unsealed.h"
#include "session/comparison.h"
#include "session/messages.h"

namespace breakaway {

/// What a trial concealed, beside this window's answer.
struct TrialTruth {
  struct Effect {
    std::string name;
    std::vector<std::pair<QString, double>> values;  ///< by the plant's names, SI
  };
  std::vector<Effect> concealed;
  std::string outside;  ///< the plant's name of physics that the catalogue doesn't hold; else empty
  Unsealed answer;
};

class TrialRun : public QObject {
  Q_OBJECT

 public:
  TrialRun(Comparison& comparison, Messages& messages, QObject* parent = nullptr);
  ~TrialRun() override;

  /// Conceals and records; what came of it is opened in the comparison.
  void conceal(unsigned seed);
  /// A seed that nobody chose.
  void conceal();
  /// Why conceal() can't begin now; empty when it can.
  QString obstacle() const;

  bool preparing() const { return process_ != nullptr; }
  /// A trial is what the comparison shows.
  bool isOpen() const { return open_; }
  unsigned seed() const { return seed_; }
  /// Why it can't be unsealed yet; empty when it can.
  QString sealObstacle() const;
  void unseal();
  const std::optional<TrialTruth>& truth() const { return truth_; }

  /// The command that conceals; where it isn't installed, empty.
  void setProgram(const QString& program) {
    program_ = program;
    emit changed();
  }

 signals:
  void changed();

 private:
  void take(int exitCode, QProcess::ExitStatus status);
  void followInputs();

  Comparison& comparison_;
  Messages& messages_;
  QString program_;
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<QProcess> process_;
  unsigned seed_ = 0;
  bool open_ = false;
  std::optional<TrialTruth> truth_;
};

}  // namespace breakaway

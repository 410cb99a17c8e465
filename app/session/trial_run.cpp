#include "session/trial_run.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRandomGenerator>
#include <QStandardPaths>

namespace breakaway {

namespace {

QString command() {
  const QString beside = QStandardPaths::findExecutable("breakaway", {QCoreApplication::applicationDirPath()});
  return beside.isEmpty() ? QStandardPaths::findExecutable("breakaway") : beside;
}

/// The trial's files, "recording.csv", "recording2.csv" and so on.
QStringList filesOf(const QString& folder, const QString& name) {
  QStringList files;
  for (int k = 1;; ++k) {
    const QString file = folder + "/" + name + (k == 1 ? QString() : QString::number(k)) + ".csv";
    if (!QFileInfo::exists(file)) return files;
    files << file;
  }
}

TrialTruth truthIn(const QJsonObject& trial) {
  TrialTruth truth;
  truth.outside = trial["outside"].toString().toStdString();
  const QJsonArray concealed = trial["concealed"].toArray();
  for (const auto& each : concealed) {
    const QJsonObject one = each.toObject();
    TrialTruth::Effect effect{one["effect"].toString().toStdString(), {}};
    const QJsonObject values = one["parameters"].toObject();
    for (auto value = values.begin(); value != values.end(); ++value)
      effect.values.emplace_back(value.key(), value.value().toDouble());
    truth.concealed.push_back(std::move(effect));
  }
  return truth;
}

}  // namespace

TrialRun::TrialRun(Comparison& comparison, Messages& messages, QObject* parent)
    : QObject(parent), comparison_(comparison), messages_(messages), program_(command()) {
  connect(&comparison_, &Comparison::inputsChanged, this, &TrialRun::followInputs);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &TrialRun::changed);
}

TrialRun::~TrialRun() {
  if (!process_) return;
  process_->disconnect(this);
  process_->kill();
  process_->waitForFinished();
}

QString TrialRun::obstacle() const {
  if (preparing()) return tr("A trial is being recorded");
  if (comparison_.diagnosing()) return tr("A diagnosis is running");
  return program_.isEmpty() ? tr("The command breakaway, which conceals and records, isn't installed") : QString();
}

void TrialRun::conceal() {
  conceal(1 + QRandomGenerator::global()->bounded(99'999U));
}

void TrialRun::conceal(unsigned seed) {
  if (!obstacle().isEmpty()) return;
  auto folder = std::make_unique<QTemporaryDir>();
  seed_ = seed;
  open_ = false;
  truth_.reset();
  process_ = std::make_unique<QProcess>();
  connect(process_.get(), &QProcess::finished, this, &TrialRun::take);
  connect(process_.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) take(-1, QProcess::CrashExit);
  });
  folder_ = std::move(folder);
  process_->start(program_, {"trial", "--seed", QString::number(seed), "--out", folder_->filePath("trial"), "--quiet"});
  emit changed();
}

void TrialRun::take(int exitCode, QProcess::ExitStatus status) {
  const QString said = QString::fromUtf8(process_->readAllStandardError()).trimmed();
  process_.release()->deleteLater();
  const QString place = folder_->filePath("trial");
  if (status != QProcess::NormalExit || exitCode != 0) {
    messages_.warn(tr("The trial could not be recorded: %1").arg(said));
  } else {
    open_ = true;
    comparison_.openTogether({place + "/bench.json", filesOf(place, "recording"), filesOf(place, "heldout")});
    messages_.say(tr("Trial %1 is recorded: what does it conceal?").arg(seed_));
  }
  emit changed();
}

void TrialRun::followInputs() {
  const auto& recording = comparison_.recording();
  const bool ours = folder_ && recording && QString::fromStdString(recording->name()).startsWith(folder_->path());
  if (open_ && recording && !ours) open_ = false, truth_.reset();
  emit changed();
}

QString TrialRun::sealObstacle() const {
  if (!open_) return tr("No sealed trial is open");
  return comparison_.diagnosis() ? QString() : tr("Diagnose first: the answer has to be in");
}

void TrialRun::unseal() {
  if (!sealObstacle().isEmpty()) return;
  QFile file(folder_->filePath("trial/trial.json"));
  if (!file.open(QIODevice::ReadOnly)) return messages_.warn(tr("The trial's truth can't be read"));
  truth_ = truthIn(QJsonDocument::fromJson(file.readAll()).object());
  std::vector<std::string> concealed, named;
  for (const TrialTruth::Effect& effect : truth_->concealed) concealed.push_back(effect.name);
  for (const Finding& finding : comparison_.diagnosis()->findings) named.push_back(finding.effect);
  truth_->answer = breakaway::unseal(concealed, !truth_->outside.empty(), named, comparison_.diagnosis()->verdict);
  emit changed();
}

}  // namespace breakaway

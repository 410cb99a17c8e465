#include "widgets/trial_strip.h"

#include <QHBoxLayout>

#include "session/trial_run.h"
#include "widgets/controls.h"
#include "widgets/findings_list.h"
#include "widgets/look.h"
#include "widgets/parameter_words.h"

namespace breakaway {

namespace {

QString titles(const std::vector<std::string>& effects) {
  QStringList words;
  for (const std::string& effect : effects) words << effectTitle(effect);
  return words.join(", ");
}

QString truthInWords(const TrialTruth& truth) {
  QStringList concealed;
  for (const TrialTruth::Effect& effect : truth.concealed) {
    QStringList values;
    for (const auto& [name, value] : effect.values) values << wordsOf({name.toStdString(), value, value, value}).line();
    const QString title = truth.outside.empty() ? effectTitle(effect.name) : QString::fromStdString(effect.name);
    concealed << (values.isEmpty() ? title : QString("%1 (%2)").arg(title, values.join(", ")));
  }
  QString words = concealed.isEmpty() ? TrialStrip::tr("Nothing was concealed.")
                                      : TrialStrip::tr("Concealed was %1.").arg(concealed.join("; "));
  if (!truth.outside.empty()) words += " " + TrialStrip::tr("The catalogue has no name for it.");
  if (truth.answer.isRight) return words + " " + TrialStrip::tr("The answer is right.");
  if (!truth.answer.missed.empty()) words += " " + TrialStrip::tr("Missed: %1.").arg(titles(truth.answer.missed));
  if (!truth.answer.wrong.empty()) words += " " + TrialStrip::tr("Wrong: %1.").arg(titles(truth.answer.wrong));
  if (truth.answer.missed.empty() && truth.answer.wrong.empty())
    words += " " + TrialStrip::tr("The answer is not right.");
  return words;
}

}  // namespace

TrialStrip::TrialStrip(TrialRun& trial, QWidget* parent) : QFrame(parent), trial_(trial) {
  setObjectName("trialStrip");
  setProperty("role", "card");
  auto* row = rowIn(this, 12, {20, 6, 12, 6});
  words_ = new QLabel(this);
  words_->setObjectName("trialWords");
  words_->setWordWrap(true);
  unseal_ = pushButton(this, "unsealButton", tr("Unseal"));
  row->addWidget(words_, 1);
  row->addWidget(unseal_);
  connect(unseal_, &QPushButton::clicked, &trial_, &TrialRun::unseal);
  connect(&trial_, &TrialRun::changed, this, &TrialStrip::show);
  show();
}

void TrialStrip::show() {
  setVisible(trial_.isOpen());
  const auto& truth = trial_.truth();
  words_->setText(
      truth ? tr("Trial %1: %2").arg(trial_.seed()).arg(truthInWords(*truth))
            : tr("Trial %1 is sealed: the window has seen its bench and recordings alone.").arg(trial_.seed()));
  dressAs(this, "tone", !truth ? QString() : truth->answer.isRight ? QString("good") : QString("warning"));
  setAvailable(unseal_, tr("Say what the trial concealed, beside the answer"),
               truth ? tr("It is unsealed: what was concealed stands here") : trial_.sealObstacle());
}

}  // namespace breakaway

#include "widgets/verdict_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "session/comparison.h"
#include "session/language.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/findings_list.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/parameter_words.h"

namespace breakaway {

namespace {

constexpr int cardHeight = 104, barsWidth = 340, leastBarsWidth = 244, nameWidth = 108, textWidth = 84, barHeight = 12,
              barStep = 21, proofHeight = 28;

QString verdictSentence(const Diagnosis& diagnosis) {
  if (diagnosis.misread) return VerdictCard::tr("A scale or sign is wrong, so that nothing else was looked for");
  QStringList names;
  for (const Finding& finding : diagnosis.findings) names << effectTitle(finding.effect);
  const QString list = names.join(", ");
  switch (diagnosis.verdict) {
    case Verdict::nothingMissing:
      return VerdictCard::tr("Nothing is missing: the base model explains the recording");
    case Verdict::named:
      return names.size() == 1 ? list : VerdictCard::tr("%1 are missing").arg(list);
    case Verdict::ambiguous:
      return VerdictCard::tr("%1: the data allow another name, too").arg(list);
    case Verdict::outsideCatalogue:
      return list.isEmpty() ? VerdictCard::tr("Something is missing that has no name in the catalogue")
                            : VerdictCard::tr("%1, and something unnamed").arg(list);
    case Verdict::undecided:
      return VerdictCard::tr("These recordings can't tell");
  }
  return {};
}

QString toneOf(const Diagnosis& diagnosis) {
  if (diagnosis.misread) return "trouble";
  switch (diagnosis.verdict) {
    case Verdict::nothingMissing:
    case Verdict::named:
      return "good";
    case Verdict::ambiguous:
    case Verdict::undecided:
      return "warning";
    case Verdict::outsideCatalogue:
      return "trouble";
  }
  return {};
}

}  // namespace

class VerdictCard::Bars : public QWidget {
 public:
  explicit Bars(QWidget* parent) : QWidget(parent) {
    setMinimumWidth(leastBarsWidth);
    setMaximumWidth(barsWidth);
    setFixedHeight(3 * barStep);
    setToolTip(
        VerdictCard::tr("RMS error on data that the fit never saw. The line is what noise of the sensors, the "
                        "unknown start of each window and the friction's own wander leave to a perfect model."));
  }
  QSize sizeHint() const override { return {barsWidth, 3 * barStep}; }
  void show(const FitScore* fit) {
    shown_ = fit != nullptr;
    if (fit != nullptr) fit_ = *fit;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    if (!shown_) return;
    const Look& look = Look::of(palette());
    QPainter painter(this);
    painter.setFont(typed(Type::caption));
    const double most = std::max({fit_.heldoutBefore, fit_.heldoutAfter, floor(), 1e-300});
    const double room = width() - nameWidth - textWidth;
    const auto row = [&](int at, const QString& name, double value, const QColor& colour) {
      const int y = 2 + barStep * at;
      painter.setPen(look.ink);
      painter.drawText(QRect(0, y, nameWidth - 8, barHeight), Qt::AlignRight | Qt::AlignVCenter, name);
      const QRectF bar(nameWidth, y, std::max(1.0, room * value / most), barHeight);
      painter.fillRect(bar, colour);
      painter.drawText(QRectF(bar.right() + 6, y, textWidth, barHeight), Qt::AlignLeft | Qt::AlignVCenter,
                       channelText(value, fit_.channel));
    };
    row(0, VerdictCard::tr("base model"), fit_.heldoutBefore, look.curve(1));
    row(1, VerdictCard::tr("with findings"), fit_.heldoutAfter, look.curve(0));
    const double x = nameWidth + room * floor() / most;
    painter.setPen(QPen(look.good, 2));
    painter.drawLine(QPointF(x, 0), QPointF(x, 2 * barStep + barHeight + 2));
    painter.setPen(look.good);
    painter.drawText(QRect(0, 2 * barStep, nameWidth - 8, 16), Qt::AlignRight | Qt::AlignVCenter,
                     VerdictCard::tr("perfect model"));
    painter.drawText(QRectF(std::min(x + 6.0, width() - 1.0 * textWidth), 2 * barStep, textWidth, 16),
                     Qt::AlignLeft | Qt::AlignVCenter, channelText(floor(), fit_.channel));
  }

 private:
  double floor() const { return fit_.floorWithWander > 0.0 ? fit_.floorWithWander : fit_.floor; }

  FitScore fit_;
  bool shown_ = false;
};

VerdictCard::VerdictCard(Comparison& comparison, QWidget* parent) : QFrame(parent), comparison_(comparison) {
  setObjectName("verdictCard");
  setProperty("role", "card");
  setFixedHeight(cardHeight);
  auto* column = columnIn(this, 2, {20, 8, 16, 8});
  title_ = new ElidedLabel("verdict", this);
  title_->setFont(typed(Type::section));
  column->addWidget(title_);
  auto* row = new QHBoxLayout;
  row->setSpacing(16);
  column->addLayout(row, 1);
  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  auto* figures = new QHBoxLayout;
  figure_ = new QLabel(this);
  figure_->setObjectName("verdictFigure");
  figure_->setFont(typed(Type::figure));
  change_ = new QLabel(this);
  change_->setObjectName("verdictChange");
  change_->setFixedHeight(24);
  figures->addWidget(figure_);
  figures->addSpacing(12);
  figures->addWidget(change_);
  figures->addStretch(1);
  proof_ = new QLabel(this);
  proof_->setObjectName("verdictProof");
  proof_->setWordWrap(true);
  proof_->setFixedHeight(proofHeight);
  proof_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  proof_->setFont(typed(Type::caption));
  proof_->setProperty("tone", "muted");
  words->addLayout(figures);
  words->addWidget(proof_);
  words->addStretch(1);
  row->addLayout(words, 1);
  bars_ = new Bars(this);
  row->addWidget(bars_, 0, Qt::AlignTop);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &VerdictCard::show);
  connect(&comparison_, &Comparison::progressChanged, this, &VerdictCard::show);
  show();
}

void VerdictCard::show() {
  const auto& diagnosis = comparison_.diagnosis();
  bars_->show(diagnosis ? &diagnosis->fit : nullptr);
  dressAs(this, "tone", diagnosis ? toneOf(*diagnosis) : QString());
  change_->setVisible(diagnosis.has_value());
  figure_->setVisible(diagnosis || comparison_.diagnosing());
  if (!diagnosis) {
    title_->setText(comparison_.diagnosing() ? tr("Diagnosing: %1").arg(comparison_.activity())
                                             : tr("Not diagnosed yet"));
    figure_->setText(comparison_.diagnosing() ? tr("%1 %").arg(100.0 * comparison_.progress(), 0, 'f', 0) : QString());
    proof_->setText(tr("Diagnose says which physics was left out, how big it is, and proves it on unseen data"));
    return;
  }
  const FitScore& fit = diagnosis->fit;
  title_->setText(verdictSentence(*diagnosis));
  // A unit that both have is said once.
  QString before = channelText(fit.heldoutBefore, fit.channel);
  const QString after = channelText(fit.heldoutAfter, fit.channel);
  if (const QString unit = after.section(' ', 1); !unit.isEmpty() && before.section(' ', 1) == unit)
    before.chop(unit.size() + 1);
  figure_->setText(tr("%1 → %2").arg(before, after));
  const double better = 100.0 * (1.0 - fit.heldoutAfter / std::max(fit.heldoutBefore, 1e-300));
  change_->setText(better >= 0.5 ? tr("−%1 %").arg(better, 0, 'f', 0) : tr("unchanged"));
  dressAs(change_, "badge", better >= 0.5 ? "good" : "open");
  if (diagnosis->misread) {
    proof_->setText(tr("RMS error of the base model with %1").arg(inLanguage(diagnosis->misread->mended)));
    return;
  }
  proof_->setText(tr("RMS error on %1 in windows of %2 s; it falls by %3 to %4 % (95 % interval)")
                      .arg(fit.separateRecording ? tr("the held-out recording") : tr("unseen parts"))
                      .arg(plainText(fit.window_s))
                      .arg(100.0 * fit.improvementLow95, 0, 'f', 0)
                      .arg(100.0 * fit.improvementHigh95, 0, 'f', 0));
}

}  // namespace breakaway

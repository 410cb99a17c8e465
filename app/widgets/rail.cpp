#include "widgets/rail.h"

#include <QPainter>
#include <QStyledItemDelegate>

#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr int rowHeight = 52, markSize = 18, markLeft = 16, textLeft = 44, edge = 3;

enum Role { markRole = Qt::UserRole, wordsRole, toolRole, tipRole };

class RailRow : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {Rail::width_px, rowHeight}; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Look& look = Look::of(option.palette);
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    const bool focused = option.state.testFlag(QStyle::State_HasFocus);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRect row = option.rect;
    if (chosen || option.state.testFlag(QStyle::State_MouseOver))
      painter->fillRect(row, chosen ? look.selected : mixed(look.surface, look.selected, 0.5));
    if (chosen) painter->fillRect(QRect(row.left(), row.top(), edge, row.height()), look.accentLine);
    if (focused) {
      painter->setPen(QPen(look.accentLine, 2));
      painter->setBrush(Qt::NoBrush);
      painter->drawRect(row.adjusted(2, 2, -2, -2));
    }
    const bool tool = index.data(toolRole).toBool();
    const int left = tool ? markLeft : textLeft;
    const auto mark = static_cast<StepMark>(index.data(markRole).toInt());
    if (!tool) {
      const QRectF circle(row.left() + markLeft, row.center().y() - markSize / 2.0, markSize, markSize);
      paintMark(*painter, circle, mark, look);
    }
    paintWords(*painter, row.adjusted(left, 9, -8, -9), index, chosen, look);
    painter->restore();
  }

 private:
  static void paintWords(QPainter& painter, const QRect& box, const QModelIndex& index, bool chosen, const Look& look) {
    painter.setFont(typed(Type::body, chosen));
    painter.setPen(look.ink);
    const auto line = [&](const QString& text, Qt::Alignment where) {
      painter.drawText(box, static_cast<int>(where | Qt::AlignLeft),
                       painter.fontMetrics().elidedText(text, Qt::ElideRight, box.width()));
    };
    const QString words = index.data(wordsRole).toString();
    line(index.data(Qt::DisplayRole).toString(), words.isEmpty() ? Qt::AlignVCenter : Qt::AlignTop);
    painter.setFont(typed(Type::caption));
    painter.setPen(look.muted);
    line(words, Qt::AlignBottom);
  }

  static void paintMark(QPainter& painter, const QRectF& circle, StepMark mark, const Look& look) {
    const QPointF centre = circle.center();
    const auto filled = [&](const QColor& colour) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(colour);
      painter.drawEllipse(circle);
      painter.setPen(QPen(look.surface, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    };
    switch (mark) {
      case StepMark::open:
        painter.setPen(QPen(look.border, 1.6));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(circle.adjusted(1, 1, -1, -1));
        break;
      case StepMark::done:
        filled(look.good);
        painter.drawPolyline(QPolygonF({centre + QPointF(-4, 0), centre + QPointF(-1, 3), centre + QPointF(4, -3)}));
        break;
      case StepMark::running:
        painter.setPen(QPen(look.accentLine, 2.4, Qt::SolidLine, Qt::FlatCap));
        painter.setBrush(Qt::NoBrush);
        painter.drawArc(circle.adjusted(1, 1, -1, -1), 90 * 16, -290 * 16);
        painter.setPen(Qt::NoPen);
        painter.setBrush(look.accentLine);
        painter.drawEllipse(centre, 3.0, 3.0);
        break;
      case StepMark::paused:
        filled(look.warning);
        painter.drawLine(centre + QPointF(-2.5, -3), centre + QPointF(-2.5, 3));
        painter.drawLine(centre + QPointF(2.5, -3), centre + QPointF(2.5, 3));
        break;
      case StepMark::trouble:
        filled(look.trouble);
        painter.drawLine(centre + QPointF(-3, -3), centre + QPointF(3, 3));
        painter.drawLine(centre + QPointF(-3, 3), centre + QPointF(3, -3));
        break;
    }
  }
};

}  // namespace

Rail::Rail(QWidget* parent) : QListWidget(parent) {
  setObjectName("steps");
  setAccessibleName(tr("Steps of the job"));
  setToolTip(tr("Steps of the job; Ctrl and a number goes to one"));
  setFixedWidth(width_px);
  setFrameShape(QFrame::NoFrame);
  setStyleSheet("border: 0; border-radius: 0;");
  setMouseTracking(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setItemDelegate(new RailRow(this));
}

void Rail::add(const QString& title, const QString& tip, bool tool) {
  auto* item = new QListWidgetItem(title, this);
  item->setData(toolRole, tool);
  item->setData(tipRole, tip);
  item->setToolTip(tip);
}

void Rail::setState(int row, const StepState& state) {
  QListWidgetItem* one = item(row);
  one->setData(markRole, static_cast<int>(state.mark));
  one->setData(wordsRole, state.words);
  one->setData(Qt::AccessibleDescriptionRole, state.words);
  const QString tip = one->data(tipRole).toString();  // whole, what the row may have no room for
  one->setToolTip(state.words.isEmpty() ? tip : state.words + "\n" + tip);
}

int Rail::rowsHeight_px() const {
  return count() * rowHeight;
}

}  // namespace breakaway

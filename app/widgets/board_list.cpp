#include "widgets/board_list.h"

#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

#include "firmware_link/presets.h"
#include "firmware_link/transport/byte_address.h"
#include "widgets/look.h"
#include "widgets/while_shown.h"

namespace breakaway {

using namespace std::chrono_literals;

namespace {
constexpr int titleHeight = 32, firstTitleHeight = 24;
constexpr int uriRole = Qt::UserRole, kindRole = Qt::UserRole + 1;
constexpr const char *rigKind = "rig", *portKind = "port";
constexpr int aboutGap = 12, besideText = 4;

/// A board's name, and muted behind it what it is.
class BoardRow : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const QString about = index.data(BoardList::aboutRole).toString();
    if (about.isEmpty()) return;
    const QFontMetrics small(typed(Type::caption));
    const int from = option.rect.left() + besideText + aboutGap +
                     option.fontMetrics.horizontalAdvance(index.data(Qt::DisplayRole).toString());
    const QRect room(from, option.rect.top(), option.rect.right() - besideText - from, option.rect.height());
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    painter->save();
    painter->setFont(typed(Type::caption));
    painter->setPen(chosen ? option.palette.color(QPalette::HighlightedText) : Look::of(option.palette).muted);
    painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, small.elidedText(about, Qt::ElideRight, room.width()));
    painter->restore();
  }
};

/// In a word or two.
QString aboutPreset(const QString& preset) {
  if (preset == "servo") return BoardList::tr("to begin with");
  if (preset == "geared") return BoardList::tr("14:1 gear");
  if (preset == "linear") return BoardList::tr("axis between stops");
  if (preset == "uneven") return BoardList::tr("friction in one swing");
  if (preset == "published-0134") return BoardList::tr("little friction");
  return {};
}
}  // namespace

BoardList::BoardList(QWidget* parent) : QListWidget(parent) {
  setObjectName("boardList");
  setToolTip(tr("Boards that can be connected; a double click connects"));
  setAccessibleName(tr("Boards to connect to"));
  setItemDelegate(new BoardRow(this));
  addTitle(tr("Simulated"));
  for (const std::string& name : presetNames()) {
    const QString preset = QString::fromStdString(name);
    const QString uri = "simulated:" + preset;
    auto* item = add(count(), preset, uri, presetWords(preset, uri));
    item->setData(kindRole, rigKind);
    item->setData(aboutRole, aboutPreset(preset));
    if (preset == "servo") setCurrentItem(item);
  }
  addTitle(tr("On a serial port"));
  addTitle(tr("On the network"));
  add(count(), tr("TCP address…"), "tcp:127.0.0.1:2000",
      tr("A board behind a network adapter, or breakaway-board on this machine: write its address below"));
  new WhileShown(this, 1s, [this] {
    showPorts(serialPorts());
    return true;
  });
  shown_ = {"nothing yet"};
  showPorts(serialPorts());
}

QString BoardList::presetWords(const QString& preset, const QString& uri) {
  if (preset == "servo") return tr("A servo motor of 0.07 Nm/A with an index; the one to begin with");
  if (preset == "geared") return tr("A small motor with a 14:1 gear behind it, seen from the motor's shaft");
  if (preset == "linear") return tr("A linear axis with a stop at each end");
  if (preset == "uneven") return tr("The servo, with 40 % of its friction in one swing around the rotor");
  if (preset == "published-0134")
    return tr("A motor of 0.134 Nm/A with very little friction, as in a published simulation");
  return uri;
}

QListWidgetItem* BoardList::add(int row, const QString& text, const QString& uri, const QString& tip) {
  auto* item = new QListWidgetItem(text);
  item->setData(uriRole, uri);
  item->setToolTip(tip);
  insertItem(row, item);
  return item;
}

void BoardList::addTitle(const QString& text) {
  auto* item = new QListWidgetItem(text, this);
  item->setFlags(Qt::NoItemFlags);
  item->setFont(typed(Type::caption, true));
  item->setTextAlignment(Qt::AlignLeft | Qt::AlignBottom);
  item->setSizeHint({0, count() == 1 ? firstTitleHeight : titleHeight});
}

int BoardList::rowBelowRigs() const {
  int below = 0;
  for (int row = 0; row < count(); ++row) {
    if (item(row)->data(kindRole) == rigKind) below = row + 1;
  }
  return below;
}

QString BoardList::address() const {
  return currentItem() != nullptr ? currentItem()->data(uriRole).toString() : QString();
}

void BoardList::addRig(const QString& name, const QString& uri) {
  auto* item = add(rowBelowRigs(), name, uri, uri);
  item->setData(kindRole, rigKind);
  setCurrentItem(item);
  ownRigs_[name] = uri;
}

QVariant BoardList::kept() const {
  return QVariantList{ownRigs_, address()};
}

void BoardList::take(const QVariant& kept) {
  const QVariantMap rigs = kept.toList().value(0).toMap();
  for (auto rig = rigs.cbegin(); rig != rigs.cend(); ++rig) addRig(rig.key(), rig.value().toString());
  for (int row = 0; row < count(); ++row) {
    if (item(row)->data(uriRole) == kept.toList().value(1)) setCurrentRow(row);
  }
}

void BoardList::showPorts(const std::vector<SerialPort>& ports) {
  std::vector<QString> addresses;
  addresses.reserve(ports.size());
  for (const SerialPort& one : ports) {
    addresses.push_back(QString("serial:%1@%2").arg(QString::fromStdString(one.lasting)).arg(ByteAddress::usualBaud));
  }
  if (addresses == shown_) return;
  const QString chosen = address();
  shown_ = addresses;
  for (int row = count() - 1; row >= 0; --row) {
    if (item(row)->data(kindRole) == portKind) delete takeItem(row);
  }
  int at = rowBelowRigs() + 1;
  for (size_t k = 0; k < ports.size(); ++k) {
    const SerialPort& port = ports[k];
    auto* item = add(at++, QString::fromStdString(port.words()), addresses[k],
                     QString::fromStdString(port.maker.empty() ? port.device : port.maker + ", " + port.device));
    item->setData(kindRole, portKind);
    if (addresses[k] == chosen) setCurrentItem(item);
  }
  if (!ports.empty()) return;
  auto* none = add(at, tr("nothing is plugged in"), {},
                   tr("Plug the board in; its port appears here by itself. A cable that only charges carries no data"));
  none->setData(kindRole, portKind);
  none->setFlags(Qt::NoItemFlags);
}

}  // namespace breakaway

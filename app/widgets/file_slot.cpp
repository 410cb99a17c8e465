#include "widgets/file_slot.h"

#include <QHBoxLayout>
#include <QLabel>

#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/look.h"

namespace breakaway {

namespace {
constexpr int slotHeight = 36, titleWidth = 68;
}  // namespace

FileSlot::FileSlot(const char* objectName, const QString& title, const QString& tip, QWidget* parent)
    : QPushButton(parent), title_(title) {
  setObjectName(objectName);
  setToolTip(tip);
  setFixedHeight(slotHeight);
  auto* row = rowIn(this, 8, {12, 0, 12, 0});
  auto* what = caption(this, title);
  what->setFixedWidth(titleWidth);
  name_ = new ElidedLabel("", this);
  about_ = new QLabel(this);  // short, and said whole: the name gives way
  about_->setFont(typed(Type::caption));
  about_->setProperty("tone", "muted");
  about_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  for (QWidget* part : std::initializer_list<QWidget*>{what, name_, about_})
    part->setAttribute(Qt::WA_TransparentForMouseEvents);
  row->addWidget(what);
  row->addWidget(name_, 1);
  row->addWidget(about_);
  show({}, {});
}

void FileSlot::show(const QString& name, const QString& about) {
  name_->setText(name.isEmpty() ? tr("Open…") : name);
  about_->setText(about);
  setAccessibleName(name.isEmpty() ? tr("%1: none").arg(title_) : QString("%1: %2").arg(title_, name));
}

}  // namespace breakaway

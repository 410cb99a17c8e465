#include "widgets/runs_table.h"

#include <QAbstractTableModel>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <functional>

#include "widgets/look.h"
#include "widgets/run_words.h"

namespace breakaway {

namespace {

constexpr int row_px = 26;

struct Heading {
  const char* words;
  int width_px;
};

constexpr Heading headings[] = {{QT_TRANSLATE_NOOP("breakaway::RunsTable", "When"), 128},
                                {QT_TRANSLATE_NOOP("breakaway::RunsTable", "What"), 108},
                                {QT_TRANSLATE_NOOP("breakaway::RunsTable", "Motor"), 72},
                                {QT_TRANSLATE_NOOP("breakaway::RunsTable", "Board"), 96},
                                {QT_TRANSLATE_NOOP("breakaway::RunsTable", "Name"), 116},
                                {QT_TRANSLATE_NOOP("breakaway::RunsTable", "Result"), 200},
                                {QT_TRANSLATE_NOOP("breakaway::RunsTable", "Remark"), 110}};

bool isWritten(int column) {
  return column == RunsTable::nameColumn || column == RunsTable::remarkColumn;
}

}  // namespace

class RunsTable::Model : public QAbstractTableModel {
 public:
  explicit Model(RunsTable& table) : QAbstractTableModel(&table), table_(table) {}

  void show(const std::vector<ProjectRun>& runs) {
    beginResetModel();
    runs_ = runs;
    endResetModel();
  }
  const std::vector<ProjectRun>& runs() const { return runs_; }
  bool hasText(int column) const {
    return std::any_of(runs_.begin(), runs_.end(),
                       [&](const ProjectRun& run) { return !textOf(run, column).isEmpty(); });
  }

  int rowCount(const QModelIndex& parent) const override {
    return parent.isValid() ? 0 : static_cast<int>(runs_.size());
  }
  int columnCount(const QModelIndex& parent) const override {
    return parent.isValid() ? 0 : static_cast<int>(std::size(headings));
  }

  QVariant data(const QModelIndex& index, int role) const override {
    const ProjectRun& run = runs_[static_cast<size_t>(index.row())];
    if (role == Qt::DisplayRole || role == Qt::EditRole) return textOf(run, index.column());
    if (role != Qt::ToolTipRole) return {};
    if (index.column() == deviceColumn) return QString::fromStdString(run.device);
    return isWritten(index.column()) ? tr("%1\nDouble click or F2 to write").arg(textOf(run, index.column())).trimmed()
                                     : textOf(run, index.column());
  }

  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) return int(Qt::AlignLeft | Qt::AlignVCenter);
    return role == Qt::DisplayRole ? RunsTable::tr(headings[section].words) : QVariant();
  }

  Qt::ItemFlags flags(const QModelIndex& index) const override {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return isWritten(index.column()) ? flags | Qt::ItemIsEditable : flags;
  }

  bool setData(const QModelIndex& index, const QVariant& value, int role) override {
    if (role != Qt::EditRole || !isWritten(index.column())) return false;
    ProjectRun& run = runs_[static_cast<size_t>(index.row())];
    std::string& text = index.column() == nameColumn ? run.name : run.remark;
    const QString written = value.toString().trimmed();
    if (written.toStdString() == text) return false;
    text = written.toStdString();
    emit dataChanged(index, index);
    table_.shareOutWidth();
    index.column() == nameColumn ? emit table_.renamed(run.id, written) : emit table_.remarked(run.id, written);
    return true;
  }

 private:
  static QString textOf(const ProjectRun& run, int column) {
    switch (column) {
      case atColumn:
        return timeInWords(run);
      case kindColumn:
        return kindInWords(run.kind);
      case motorColumn:
        return QString::fromStdString(run.motor);
      case deviceColumn:
        return QString::fromStdString(run.device).section(", ", -1);  // "rig servo" of "simulated board, rig servo"
      case nameColumn:
        return QString::fromStdString(run.name);
      case resultColumn:
        return resultInWords(run);
      default:
        return QString::fromStdString(run.remark);
    }
  }

  RunsTable& table_;
  std::vector<ProjectRun> runs_;
};

RunsTable::RunsTable(QWidget* parent) : QTableView(parent), model_(new Model(*this)) {
  setObjectName("runsTable");
  setAccessibleName(tr("Runs of the project"));
  setToolTip(tr("Enter opens a run, F2 writes its name or remark, Shift chooses several"));
  setModel(model_);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  setAlternatingRowColors(true);
  setCornerButtonEnabled(false);
  setTabKeyNavigation(false);
  setShowGrid(false);
  setWordWrap(false);
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(row_px);
  horizontalHeader()->setHighlightSections(false);
  shareOutWidth();
  horizontalHeader()->setSectionResizeMode(resultColumn, QHeaderView::Stretch);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (!filling_) emit chosenChanged();
  });
  connect(this, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    if (!isWritten(index.column())) emit opened();
  });
}

RunsTable::~RunsTable() = default;

void RunsTable::show(const std::vector<ProjectRun>& runs, const QString& instead) {
  instead_ = instead;
  if (runs == model_->runs() || state() == EditingState) return;
  const QStringList before = kept().toStringList();
  filling_ = true;
  model_->show(runs);
  filling_ = false;
  shareOutWidth();
  select(before);
}

/// A column in which nothing stands takes its heading's room alone, or none; results take what is left.
void RunsTable::shareOutWidth() {
  for (int column = 0; column < static_cast<int>(std::size(headings)); ++column) {
    if (column == resultColumn) continue;
    const bool has = model_->hasText(column);
    if (!isWritten(column)) setColumnHidden(column, !has && model_->rowCount({}) > 0);  // nobody can write there
    if (columnHasText_[static_cast<size_t>(column)] == has) continue;
    columnHasText_[static_cast<size_t>(column)] = has;
    setColumnWidth(column, has ? headings[column].width_px : horizontalHeader()->sectionSizeHint(column));
  }
}

void RunsTable::select(const QStringList& ids) {
  filling_ = true;
  QItemSelection again;
  for (int row = 0; row < model_->rowCount({}); ++row) {
    if (!ids.contains(QString::fromStdString(model_->runs()[static_cast<size_t>(row)].id))) continue;
    again.select(model_->index(row, 0), model_->index(row, model_->columnCount({}) - 1));
  }
  selectionModel()->select(again, QItemSelectionModel::ClearAndSelect);
  filling_ = false;
  emit chosenChanged();
}

QVariant RunsTable::kept() const {
  QStringList ids;
  for (const ProjectRun& run : chosen()) ids << QString::fromStdString(run.id);
  return ids;
}

void RunsTable::take(const QVariant& kept) {
  select(kept.toStringList());
}

void RunsTable::paintEvent(QPaintEvent* event) {
  QTableView::paintEvent(event);
  if (!model_->runs().empty()) return;
  QPainter painter(viewport());
  painter.setPen(Look::of(palette()).muted);
  painter.drawText(viewport()->rect(), Qt::AlignCenter | Qt::TextWordWrap, instead_);
}

std::vector<ProjectRun> RunsTable::chosen() const {
  QModelIndexList rows = selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  std::vector<ProjectRun> runs;
  runs.reserve(static_cast<size_t>(rows.size()));
  for (const QModelIndex& row : rows) runs.push_back(model_->runs()[static_cast<size_t>(row.row())]);
  return runs;
}

void RunsTable::choose(const std::string& id) {
  const auto& runs = model_->runs();
  const auto found = std::find_if(runs.begin(), runs.end(), [&](const ProjectRun& run) { return run.id == id; });
  if (found == runs.end()) return clearSelection();
  const QModelIndex index = model_->index(static_cast<int>(found - runs.begin()), 0);
  setCurrentIndex(index);
  selectRow(index.row());
}

void RunsTable::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && state() != EditingState) {
    emit opened();
    return;
  }
  QTableView::keyPressEvent(event);
}

}  // namespace breakaway

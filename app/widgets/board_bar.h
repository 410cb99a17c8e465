// The bar that is always there: device, firmware, link, lost samples, state, and STOP.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace breakaway {

class Connection;

class BoardBar : public QWidget {
  Q_OBJECT

 public:
  explicit BoardBar(Connection& connection, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QLabel* addField(const char* objectName, const QString& title, int width);
  void showConnection();
  void showLink();
  void showState();
  void styleStop();

  Connection& connection_;
  QLabel* device_ = nullptr;
  QLabel* firmware_ = nullptr;
  QLabel* link_ = nullptr;
  QLabel* lost_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* simulated_ = nullptr;
  QPushButton* stop_ = nullptr;
};

}  // namespace breakaway

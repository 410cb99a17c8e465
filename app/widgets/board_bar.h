// The bar that is always there: device, firmware, link, lost samples, state, and STOP.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace breakaway {

class Session;

class BoardBar : public QWidget {
  Q_OBJECT

 public:
  explicit BoardBar(Session& session, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QLabel* addField(const char* objectName, const QString& title, int width);
  void showConnection();
  void showLink();
  void showState();
  void styleStop();

  Session& session_;
  QLabel* device_ = nullptr;
  QLabel* firmware_ = nullptr;
  QLabel* link_ = nullptr;
  QLabel* lost_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* simulated_ = nullptr;
  QPushButton* stop_ = nullptr;
};

}  // namespace breakaway

#include "widgets/look.h"

#include <QApplication>
#include <QEvent>
#include <QWidget>
#include <array>
#include <cmath>

namespace breakaway {

namespace {

class LookWatch : public QObject {
 public:
  LookWatch(QWidget* watched, std::function<void()> dress) : QObject(watched), dress_(std::move(dress)) {
    watched->installEventFilter(this);
  }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) dress_();
    return false;
  }

 private:
  std::function<void()> dress_;
};

Look lightLook() {
  Look look;
  look.page = 0xf5f6f8;
  look.surface = 0xffffff;
  look.ink = 0x1b2027;
  look.muted = 0x59616c;
  look.disabled = 0x66707c;
  look.border = 0x7f8793;
  look.hairline = 0xd5dae0;
  look.grid = 0xe3e6ea;
  look.accent = 0x1b62b0;
  look.accentLine = 0x1b62b0;
  look.selected = 0xe3edf8;
  look.stop = 0xc21818;
  look.stopBorder = 0xc21818;
  look.trouble = 0xa3170c;
  look.troubleBack = 0xfde8e6;
  look.warning = 0x7a4b00;
  look.warningBack = 0xfff4d6;
  look.good = 0x0b6b4b;
  look.goodBack = 0xe3f4ec;
  look.simulated = 0x6a3fb5;
  look.simulatedBack = 0xf0eafa;
  return look;
}

Look darkLook() {
  Look look;
  look.dark = true;
  look.page = 0x1c2026;
  look.surface = 0x15181d;
  look.ink = 0xe6e9ed;
  look.muted = 0xa4adb8;
  look.disabled = 0x8e97a3;
  look.border = 0x6c7683;
  look.hairline = 0x363d47;
  look.grid = 0x2b313a;
  look.accent = 0x2a72be;
  look.accentLine = 0x7db4ec;
  look.selected = 0x22344a;
  look.stop = 0xc21818;
  look.stopBorder = 0xe4706e;
  look.trouble = 0xffc9c2;
  look.troubleBack = 0x4a1a17;
  look.warning = 0xffdf9b;
  look.warningBack = 0x43320c;
  look.good = 0x5fd3a6;
  look.goodBack = 0x17372c;
  look.simulated = 0xb49aeb;
  look.simulatedBack = 0x2d2840;
  return look;
}

double luminance(const QColor& colour) {
  const auto linear = [](double part) {
    return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

}  // namespace

const Look& Look::light() {
  static const Look& look = lightLook();
  return look;
}

const Look& Look::inDark() {
  static const Look& look = darkLook();
  return look;
}

const Look& Look::of(const QPalette& palette) {
  // A role that no style sheet ever sets on a single widget.
  return palette.color(QPalette::Midlight).lightness() < 128 ? inDark() : light();
}

QColor Look::curve(int index) const {
  static const std::array<QColor, 5> onLight{QColor(0x0067a5), QColor(0xb84a00), QColor(0x00755a), QColor(0x9a4178),
                                             QColor(0x7a5c00)};
  static const std::array<QColor, 5> onDark{QColor(0x62b6ee), QColor(0xf0a050), QColor(0x35c79a), QColor(0xe09ac4),
                                            QColor(0xe6d23c)};
  return (dark ? onDark : onLight)[static_cast<size_t>(index) % onLight.size()];
}

QColor Look::measured(int index) const {
  return mixed(surface, curve(index), 0.5);
}

QColor Look::band(int index) const {
  QColor colour = curve(index);
  colour.setAlphaF(0.18F);
  return colour;
}

QPalette paletteOf(const Look& look) {
  QPalette palette(look.page);
  const auto set = [&palette](QPalette::ColorRole role, const QColor& colour) { palette.setColor(role, colour); };
  set(QPalette::Window, look.page);
  set(QPalette::Base, look.surface);
  set(QPalette::AlternateBase, look.page);
  set(QPalette::Button, look.surface);
  set(QPalette::Light, look.surface);
  set(QPalette::Midlight, look.grid);
  set(QPalette::Mid, look.hairline);
  set(QPalette::Dark, look.border);
  set(QPalette::Shadow, look.border);
  set(QPalette::ToolTipBase, look.surface);
  set(QPalette::PlaceholderText, look.disabled);
  set(QPalette::Highlight, look.accent);
  set(QPalette::HighlightedText, Qt::white);
  set(QPalette::BrightText, look.stop);
  set(QPalette::Link, look.accentLine);
  set(QPalette::LinkVisited, look.accentLine);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    set(role, look.ink);
    palette.setColor(QPalette::Disabled, role, look.disabled);
  }
  return palette;
}

QFont typed(Type type, bool bold) {
  QFont font = QApplication::font();
  font.setPixelSize(static_cast<int>(type));
  const bool heavy = bold || type == Type::section || type == Type::title || type == Type::figure;
  font.setWeight(heavy ? QFont::DemiBold : QFont::Normal);
  return font;
}

void onNewLook(QWidget* widget, std::function<void()> dress) {
  new LookWatch(widget, std::move(dress));
}

double contrast(const QColor& a, const QColor& b) {
  const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
  return (lighter + 0.05) / (darker + 0.05);
}

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto blend = [share](int x, int y) { return static_cast<int>(std::lround(x + (y - x) * share)); };
  return {blend(a.red(), b.red()), blend(a.green(), b.green()), blend(a.blue(), b.blue())};
}

}  // namespace breakaway

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/comparison_commands.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/view/comparison.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/command.h"
#include "picture/error_image.h"

namespace hogelscope {

namespace {

/// Two parts beside each other, or below each other where the first one would be folded.
class FoldingBar : public QWidget {
 public:
  FoldingBar() : m_parts(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
    m_parts->setContentsMargins(scaled(8), scaled(4), scaled(4), scaled(4));
    m_parts->setSpacing(0);
  }

  void add(QWidget* first, QWidget* second) {
    m_parts->addWidget(first, 1);
    m_parts->addWidget(second);
  }

 protected:
  void resizeEvent(QResizeEvent*) override {
    constexpr int wide = 700;
    m_parts->setDirection(width() < scaled(wide) ? QBoxLayout::TopToBottom
                                                 : QBoxLayout::LeftToRight);
  }

 private:
  QBoxLayout* m_parts;
};

}  // namespace

ComparisonCommands::ComparisonCommands(QMenu* menu, ImageWidget* view, QVBoxLayout* around,
                                       QObject* parent)
    : QObject(parent),
      m_menu(menu),
      m_view(view),
      m_modes(new QActionGroup(this)),
      m_kinds(new QActionGroup(this)),
      m_bar(new FoldingBar),
      m_buttons(new QHBoxLayout),
      m_figures(new QLabel),
      m_histogram(new HistogramWidget),
      m_meter(new ComparisonMeter(this)) {
  addModes();
  addErrorMaps();
  addTone();
  addHistogram(around);
  addBar(around);
  connect(m_view, &ImageWidget::regionChanged, this, &ComparisonCommands::measure);
  connect(m_meter, &ComparisonMeter::measured, this, [this](const ComparisonFigures& figures) {
    m_figures->setText(textOf(figures));
    m_histogram->setHistograms(figures.histograms, m_view->titles());
  });
}

void ComparisonCommands::addModes() {
  using Mode = ImageWidget::Mode;
  const auto add = [this](const CommandText& text, Mode mode) {
    QAction* action = addCommand(m_menu, text, this, [this, mode] { m_view->setMode(mode); });
    action->setCheckable(true);
    m_modes->addAction(action);
    return action;
  };
  add({"singleAction", tr("&One picture"), tr("Shows the session's own picture"),
       Qt::CTRL | Qt::Key_1, tr("One")},
      Mode::single);
  add({"sideBySideAction", tr("Side &by side"), tr("Both pictures, zoomed and moved together"),
       Qt::CTRL | Qt::Key_2, tr("Both")},
      Mode::sideBySide)
      ->setChecked(true);
  add({"wipeAction", tr("&Wipe"),
       tr("One picture left of a line, the other right of it; drag the line, or Shift+Left and "
          "Shift+Right"),
       Qt::CTRL | Qt::Key_3, tr("Wipe")},
      Mode::wipe);
  add({"blinkAction", tr("Bl&ink"),
       tr("The two pictures take turns, twice a second; Space: by hand"), Qt::CTRL | Qt::Key_7,
       tr("Blink")},
      Mode::blink);
  m_difference = add({"differenceAction", tr("&Difference"),
                      tr("Error of the other picture, as the error map chosen, times a gain; "
                         "Shift+Up and Shift+Down change the gain"),
                      Qt::CTRL | Qt::Key_4, tr("Error")},
                     Mode::difference);
  const std::array names{"one", "both", "wipe", "blink", "error_map"};
  for (std::size_t k = 0; k < names.size(); ++k)
    m_modes->actions()[qsizetype(k)]->setIcon(icon(names[k]));
  m_menu->addSeparator();
}

void ComparisonCommands::addErrorMaps() {
  struct MapChoice {
    ErrorKind kind;
    const char* name;
    QString help;
  };
  const std::array choices{
      MapChoice{ErrorKind::absolute, "absoluteErrorAction", tr("|t − r| of each channel")},
      MapChoice{ErrorKind::signedError, "signedErrorAction",
                tr("t − r of each channel; 0 is the middle of the scale")},
      MapChoice{ErrorKind::squared, "squaredErrorAction",
                tr("(t − r)² of each channel, of which MSE is the mean")},
      MapChoice{ErrorKind::relative, "relativeErrorAction",
                tr("|t − r| / max(r, 1) of each channel, in percent")},
      MapChoice{ErrorKind::luma, "lumaErrorAction", tr("|Y(t) − Y(r)|, Y of BT.709")}};
  m_errorMenu = m_menu->addMenu(tr("Err&or map"));
  int digit = Qt::Key_1;
  for (const MapChoice& choice : choices) {
    QAction* action = addCommand(
        m_errorMenu,
        {choice.name, ErrorText::name(choice.kind),
         tr("Shows %1 for the other picture's value t and the session's own r").arg(choice.help),
         Qt::ALT | Qt::Key(digit++)},
        m_difference, &QAction::trigger);
    action->setCheckable(true);
    action->setData(int(choice.kind));
    m_kinds->addAction(action);
  }
  m_kinds->actions().front()->setChecked(true);
  connect(m_kinds, &QActionGroup::triggered, this, &ComparisonCommands::showErrorMap);
  m_errorMenu->addSeparator();
  m_falseColour = addSwitch(m_errorMenu,
                            {"falseColourAction", tr("&False colour"),
                             tr("Shows the mean error of the channels in the colours of a scale"),
                             Qt::ALT | Qt::Key_6, tr("Colours")},
                            true, this, &ComparisonCommands::showErrorMap);
  connect(m_falseColour, &QAction::triggered, m_difference, &QAction::trigger);
  showErrorMap();
}

/// Adds the image widget's commands to the menu, with keys that work anywhere in the window.
void ComparisonCommands::addTone() {
  auto* menu = m_menu->addMenu(tr("&Gain and gamma"));
  for (const auto& [own, name, key] :
       {std::tuple("moreGainAction", "moreGainViewAction", Qt::ALT | Qt::Key_Plus),
        std::tuple("lessGainAction", "lessGainViewAction", Qt::ALT | Qt::Key_Minus),
        std::tuple("stretchAction", "stretchViewAction", Qt::ALT | Qt::Key_Asterisk),
        std::tuple("moreGammaAction", "moreGammaViewAction", Qt::ALT | Qt::Key_Period),
        std::tuple("lessGammaAction", "lessGammaViewAction", Qt::ALT | Qt::Key_Comma),
        std::tuple("resetToneAction", "resetToneViewAction", Qt::ALT | Qt::Key_0)}) {
    auto* does = m_view->findChild<QAction*>(own);
    addCommand(menu, {name, does->text(), does->toolTip(), key}, does, &QAction::trigger);
  }
}

void ComparisonCommands::showErrorMap() {
  m_view->setErrorMap(ErrorKind(m_kinds->checkedAction()->data().toInt()),
                      m_falseColour->isChecked());
}

void ComparisonCommands::addHistogram(QVBoxLayout* around) {
  m_showHistogram = addSwitch(
      m_menu,
      {"histogramAction", tr("&Histogram"),
       tr("Below the picture: how many pixels have which luma"), Qt::CTRL | Qt::SHIFT | Qt::Key_H},
      false, m_histogram, &QWidget::setVisible);
  m_showHistogram->setIcon(icon("histogram"));
  m_histogram->setObjectName("histogram");
  m_histogram->hide();
  around->addWidget(m_histogram);
  connect(m_showHistogram, &QAction::toggled, this, &ComparisonCommands::measure);
}

/// Fills the bar with the figures, and the commands of the error map and of the gain.
void ComparisonCommands::addBar(QVBoxLayout* around) {
  const auto own = [this](const char* name, const QString& word) {
    auto* action = m_view->findChild<QAction*>(name);
    action->setIconText(word);
    return action;
  };
  m_figures->setObjectName("comparisonFigures");
  m_figures->setWordWrap(true);
  m_figures->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_figures->setToolTip(
      tr("The report's metrics of the 8-bit pictures that are shown; Shift and a drag over the "
         "picture mark a rectangle, whose figures are shown too"));
  m_bar->setObjectName("comparisonBar");
  auto* buttons = new QWidget;
  buttons->setLayout(m_buttons);
  m_buttons->setContentsMargins(0, 0, 0, 0);
  m_buttons->setSpacing(0);
  static_cast<FoldingBar*>(m_bar)->add(m_figures, buttons);
  QAction* map = m_errorMenu->menuAction();
  map->setIconText(tr("Error map"));
  map->setToolTip(tr("Which error of the other picture is shown"));
  for (QAction* action :
       {map, m_falseColour, own("lessGainAction", tr("÷2")), own("moreGainAction", tr("×2"))})
    addToBar(action);
  m_bar->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Maximum);  // no wider than the image
  around->insertWidget(around->indexOf(m_view), m_bar);
  around->setStretchFactor(m_view, 1);
}

void ComparisonCommands::addToBar(QAction* action) {
  auto* button = new QToolButton;
  button->setFocusPolicy(Qt::NoFocus);  // keys stay with the image
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setPopupMode(QToolButton::InstantPopup);
  m_buttons->addWidget(button);
}

void ComparisonCommands::setComparing(bool isComparing) {
  m_modes->setEnabled(isComparing);
  m_kinds->setEnabled(isComparing);
  m_falseColour->setEnabled(isComparing);
  m_bar->setVisible(isComparing);
}

/// Measures the images, unless they are outdated or their figures are not shown.
void ComparisonCommands::measure() {
  const bool isWanted = !m_view->otherImage().isNull() || m_showHistogram->isChecked();
  if (m_view->image().isNull() || !m_view->notice().isEmpty() || !isWanted)
    return m_meter->forget();
  m_meter->measure({m_view->image(), m_view->seen(), m_view->otherImage(), m_view->otherSeen(),
                    m_view->region()});
}

}  // namespace hogelscope

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

QToolButton* buttonOf(QAction* action, Qt::ToolButtonStyle style) {
  auto* button = new QToolButton;
  button->setFocusPolicy(Qt::NoFocus);  // keys stay with the image
  button->setDefaultAction(action);
  button->setToolButtonStyle(style);
  button->setPopupMode(QToolButton::InstantPopup);
  return button;
}

/// Buttons for the modes and tools, above a line of figures. The modes have words where there is
/// room for them; the tools fold below them where there is none.
class ComparisonBar : public QWidget {
 public:
  ComparisonBar(const QList<QAction*>& modes, QLayout* tools, QWidget* figures)
      : m_row(new QBoxLayout(QBoxLayout::LeftToRight)) {
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(0);
    for (QAction* mode : modes) {
      m_modes << buttonOf(mode, Qt::ToolButtonTextBesideIcon);
      m_modes.back()->setIconSize({scaled(16), scaled(16)});
      buttons->addWidget(m_modes.back());
    }
    buttons->addStretch();
    m_row->setSpacing(0);
    m_row->addLayout(buttons, 1);
    m_row->addLayout(tools);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(scaled(8), scaled(4), scaled(4), scaled(4));
    all->setSpacing(scaled(4));
    all->addLayout(m_row);
    all->addWidget(figures);
  }

 protected:
  void resizeEvent(QResizeEvent*) override {
    constexpr int wide = 900, narrow = 540;
    m_row->setDirection(width() < scaled(narrow) ? QBoxLayout::TopToBottom
                                                 : QBoxLayout::LeftToRight);
    for (QToolButton* mode : m_modes)
      mode->setToolButtonStyle(width() < scaled(wide) ? Qt::ToolButtonIconOnly
                                                      : Qt::ToolButtonTextBesideIcon);
  }

 private:
  QBoxLayout* m_row;
  QList<QToolButton*> m_modes;
};

}  // namespace

ComparisonCommands::ComparisonCommands(QMenu* menu, ImageWidget* view, QVBoxLayout* around,
                                       QObject* parent)
    : QObject(parent),
      m_menu(menu),
      m_view(view),
      m_modes(new QActionGroup(this)),
      m_kinds(new QActionGroup(this)),
      m_buttons(new QHBoxLayout),
      m_figures(new QLabel),
      m_gain(new QLabel),
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
  m_wipe = add({"wipeAction", tr("&Wipe"),
                tr("One picture left of a line, the other right of it; drag the line, or "
                   "Shift+Left and Shift+Right"),
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
  add({"wipeAndErrorAction", tr("Wipe &and error"),
       tr("The two pictures with the wipe's line between them, and the error map beside them"),
       Qt::CTRL | Qt::Key_8},
      Mode::wipeAndError);
  const std::array names{"one", "both", "wipe", "blink", "error_map", "wipe_and_error"};
  for (std::size_t k = 0; k < names.size(); ++k)
    m_modes->actions()[qsizetype(k)]->setIcon(icon(names[k]));
  m_menu->addSeparator();
}

void ComparisonCommands::wipe() {
  m_wipe->trigger();
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
  const QAction* kind = m_kinds->checkedAction();
  m_errorMenu->menuAction()->setIconText(kind->text().remove('&'));
  m_falseColour->setIconText(m_falseColour->isChecked() ? tr("Mean, viridis") : tr("Channels"));
  m_view->setErrorMap(ErrorKind(kind->data().toInt()), m_falseColour->isChecked());
}

void ComparisonCommands::showTone() {
  const QString tone = m_view->toneText();
  m_gain->setText(tone.isEmpty() ? tr("× 1") : tone);
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

/// Fills the bar with the modes, the state and the commands of error map and gain, and the figures.
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
  m_buttons->setSpacing(0);
  m_bar = new ComparisonBar(m_modes->actions(), m_buttons, m_figures);
  m_bar->setObjectName("comparisonBar");
  QAction* map = m_errorMenu->menuAction();
  map->setToolTip(tr("Which error of the other picture is shown"));
  addToBar(map);
  addToBar(m_falseColour);
  addToBar(own("lessGainAction", tr("−")));
  m_gain->setObjectName("gainText");
  m_gain->setToolTip(tr("Gain and gamma of what is shown"));
  m_gain->setMinimumWidth(m_gain->fontMetrics().horizontalAdvance(tr("× 128")));
  m_gain->setAlignment(Qt::AlignCenter);
  m_buttons->addWidget(m_gain);
  addToBar(own("moreGainAction", tr("+")));
  connect(m_view, &ImageWidget::toneChanged, this, &ComparisonCommands::showTone);
  showTone();
  m_bar->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Maximum);  // no wider than the image
  around->insertWidget(around->indexOf(m_view), m_bar);
  around->setStretchFactor(m_view, 1);
}

void ComparisonCommands::addToBar(QAction* action) {
  m_buttons->addWidget(buttonOf(action, Qt::ToolButtonTextOnly));
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

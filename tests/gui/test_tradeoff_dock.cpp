// SPDX-License-Identifier: BSD-3-Clause
// Drives the speed-accuracy dock of the real window: what it shows, in which colours and at which
// sizes, and what a click or a key on a method does.
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QToolButton>
#include <algorithm>

#include "chart/tradeoff_chart.h"
#include "gui/docks/chart_colours.h"
#include "gui/docks/tradeoff_widget.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

class TestTradeoffDock : public WindowTest {
  Q_OBJECT

 private:
  TradeoffChartWidget* chart() const { return child<TradeoffChartWidget>("tradeoffChart"); }
  QTableWidget* table() const { return child<QTableWidget>("methodTable"); }
  QPushButton* button(const char* name) const { return child<QPushButton>(name); }
  QLabel* details() const { return child<QLabel>("methodDetails"); }
  const std::vector<TradeoffRow>& rows() const { return chart()->chart().rows(); }

  void measure() {
    child<QSpinBox>("budgetBox")->setValue(1);
    QTest::mouseClick(button("measureButton"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!rows().empty(), patience);
  }

  QPointF placeOf(std::size_t row) const {
    return *chart()->chart().axes(QSizeF(chart()->size()), chartFont()).positionOf(rows()[row]);
  }
  /// The row that is drawn nearest to another one's point, as many may be at the same place.
  std::size_t nearestTo(const QPoint& place) const {
    std::vector<double> distances;
    for (std::size_t k = 0; k < rows().size(); ++k)
      distances.push_back(QLineF(placeOf(k), place).length());
    return std::size_t(std::ranges::min_element(distances) - distances.begin());
  }
  /// The dock may be larger than the screen, so the real pointer cannot be used.
  void movePointer(const QPoint& place) {
    QMouseEvent event(QEvent::MouseMove, place, chart()->mapToGlobal(place), Qt::NoButton,
                      Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(chart(), &event);
  }
  void resizeDock(int width, int height) {
    child<QDockWidget>("tradeoffDock")->resize(width, height);
    QTRY_COMPARE_WITH_TIMEOUT(child<QDockWidget>("tradeoffDock")->width(), width, patience);
    QTRY_COMPARE_WITH_TIMEOUT(child<QDockWidget>("tradeoffDock")->height(), height, patience);
  }

 private Q_SLOTS:
  void init() {
    start();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    auto* dock = child<QDockWidget>("tradeoffDock");
    dock->show();
    dock->setFloating(true);
    resizeDock(1100, 700);
    activate(dock);
  }
  void cleanup() { m_window.reset(); }

  void itSaysWhatItWillDoAndWhatItDid() {
    QVERIFY(rows().empty());
    for (const char* name : {"movingViewCard", "defaultCard", "paperCard"})
      QVERIFY2(!button(name)->isVisible(), name);
    QVERIFY(!table()->isVisible());
    QCOMPARE(button("measureButton")->text(), QString("&Measure"));
    measure();
    const QString status = child<QLabel>("tradeoffStatus")->text();
    QVERIFY2(status.startsWith(QString("%1 methods measured in ").arg(rows().size())),
             qPrintable(status));
    QVERIFY(status.endsWith(" s"));
    QCOMPARE(button("measureButton")->text(), QString("&Measure again"));
    QVERIFY(!m_window->findChild<TradeoffWidget*>()->findChild<QProgressBar*>()->isVisible());
    QCOMPARE(table()->rowCount(), int(rows().size()));
    const std::vector<std::size_t> order = fastToSlow(rows());
    for (int line = 0; line < table()->rowCount(); ++line) {
      const TradeoffRow& row = rows()[order[std::size_t(line)]];
      QVERIFY(table()->item(line, 0)->text().startsWith(QString::fromStdString(row.method)));
      QCOMPARE(table()->item(line, 1)->text(), figureText(row.milliseconds));
      QCOMPARE(table()->item(line, 2)->text(), figureText(1000 / row.milliseconds));
      // On a slow machine a range follows, of part of the pixels.
      QVERIFY(table()->item(line, 3)->text().startsWith(figureText(row.rmse)));
      QVERIFY(!table()->item(line, 0)->icon().isNull());
    }
  }

  void cardsUseWhatIsRecommended() {
    measure();
    const std::vector<std::pair<const char*, Purpose>> cards{
        {"movingViewCard", Purpose::movingView},
        {"defaultCard", Purpose::standard},
        {"paperCard", Purpose::paper}};
    for (const auto& [name, purpose] : cards) {
      const QString method = QString::fromStdString(rows()[*recommended(rows(), purpose)].method);
      auto* label = button(name)->findChild<QLabel*>();
      QVERIFY2(label->text().contains("<b>" + method + "</b>"), name);
      const auto first = std::ranges::find_if(cards, [&](const auto& card) {
        return recommended(rows(), card.second) == recommended(rows(), purpose);
      });
      QCOMPARE(button(name)->isVisible(), first->first == name);
      if (!button(name)->isVisible()) continue;  // one card is for all that are alike
      QTest::mouseClick(label, Qt::LeftButton);  // as the pointer is over the text
      QTRY_VERIFY2_WITH_TIMEOUT(message().endsWith("method: " + method), name, patience);
      QVERIFY2(button(name)->isChecked(), name);
      QVERIFY2(label->text().contains("in use"), name);
      for (const auto& [other, otherPurpose] : cards)
        QCOMPARE(button(other)->isChecked(),
                 recommended(rows(), otherPurpose) == recommended(rows(), purpose));
      QCOMPARE(table()->item(table()->currentRow(), 0)->text().remove('*'), method);
    }
    QTest::mouseClick(button("ownMethodButton"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!message().contains("method:"), patience);
    for (const auto& [name, purpose] : cards) QVERIFY2(!button(name)->isChecked(), name);
    QVERIFY(table()->selectedItems().isEmpty());
    QVERIFY(!button("ownMethodButton")->isVisible());
  }

  void thePointerNamesTheNearestPointAndAClickUsesIt() {
    measure();
    QSignalSpy chosen(m_window->findChild<TradeoffWidget*>(), &TradeoffWidget::methodChosen);
    for (std::size_t k = 0; k < rows().size(); ++k) {
      const QPoint place = placeOf(k).toPoint() + QPoint(1, -1);
      const TradeoffRow& row = rows()[nearestTo(place)];
      const QString method = QString::fromStdString(row.method);
      movePointer(place);
      QVERIFY(details()->isVisible());
      QVERIFY(details()->text().startsWith("<b>" + method + "</b>"));
      QVERIFY(details()->text().contains(timeText(row.milliseconds)));
      QCOMPARE(details()->text().contains("faster") || details()->text().contains("as fast"),
               !row.isPareto);
      QVERIFY(chart()->rect().contains(details()->geometry()));
      QVERIFY(!details()->geometry().contains(place));
      QTest::mouseClick(chart(), Qt::LeftButton, {}, place);
      QCOMPARE(chosen.last().first().value<std::optional<NamedMethod>>()->name, row.method);
    }
    QCOMPARE(std::size_t(chosen.count()), rows().size());
    movePointer({2, 2});
    QVERIFY(!details()->isVisible());
  }

  /// Arrows choose, Return renders.
  void theTableByKeys() {
    measure();
    table()->setFocus();
    table()->setCurrentCell(0, 0);
    const auto methodOf = [this](int line) {
      return QString::fromStdString(rows()[fastToSlow(rows())[std::size_t(line)]].method);
    };
    for (int line = 1; line <= 3; ++line) {
      QTest::keyClick(table(), Qt::Key_Down);
      QCOMPARE(table()->currentRow(), line);
      QVERIFY(details()->isVisible());
      QVERIFY(details()->text().startsWith("<b>" + methodOf(line) + "</b>"));
      QVERIFY(!message().contains("method:"));
    }
    QTest::keyClick(table(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(message().endsWith("method: " + methodOf(3)), patience);
    button("measureButton")->setFocus();
    QVERIFY(!details()->isVisible());
  }

  void whatFitsIsShown() {
    measure();
    auto* widget = child<QWidget>("tradeoffView");
    const auto isBeside = [this] { return table()->x() > chart()->geometry().right(); };
    QVERIFY(table()->isVisible() && isBeside());
    const int title = child<QDockWidget>("tradeoffDock")->height() - widget->height();
    const int card = button("paperCard")->height();
    resizeDock(1100, 362 + title);
    QTRY_VERIFY_WITH_TIMEOUT(table()->isVisible(), patience);
    resizeDock(1100, 358 + title);
    QTRY_VERIFY_WITH_TIMEOUT(!table()->isVisible(), patience);
    QCOMPARE(button("paperCard")->height(), card);
    resizeDock(1100, 236 + title);
    QTRY_VERIFY_WITH_TIMEOUT(button("paperCard")->height() < card, patience);
    QVERIFY(chart()->isVisible() && chart()->height() >= 100);
    resizeDock(800, 500);
    QTRY_VERIFY_WITH_TIMEOUT(!table()->isVisible(), patience);  // neither beside nor below
    resizeDock(800, 720);
    QTRY_VERIFY_WITH_TIMEOUT(table()->isVisible(), patience);
    QVERIFY(!isBeside() && table()->y() > chart()->y());
  }

  /// One measurement has the errors for both, and the methods that smooth are nearer to the ideal.
  void bothQuestions() {
    auto* ideal = child<QToolButton>("idealQuestion");
    auto* display = child<QToolButton>("displayQuestion");
    const auto rowOf = [this](const char* method) {
      return *std::ranges::find(rows(), method, &TradeoffRow::method);
    };
    QVERIFY(ideal->isChecked() && !display->isChecked());
    measure();
    QCOMPARE(rowOf("quadrilinear 8×8").rmse, 0.0);
    QVERIFY(rowOf("exact").rmse > 0);
    const double time = rowOf("exact").milliseconds;
    QTest::mouseClick(display, Qt::LeftButton);
    QVERIFY(display->isChecked() && !rows().empty());
    QCOMPARE(rowOf("exact").rmse, 0.0);
    QVERIFY(rowOf("quadrilinear 8×8").rmse > 0);
    QCOMPARE(rowOf("exact").milliseconds, time);
    // Another sampling forgets what was measured, and the question stays.
    Session session = m_model->session();
    session.sampling.samplesPerPixel = 2;
    m_model->setContent(session);
    QTRY_VERIFY_WITH_TIMEOUT(rows().empty(), patience);
    QVERIFY(display->isChecked());
  }

  void coloursFollowTheScheme() {
    measure();
    const auto cornerOf = [this] { return chart()->grab().toImage().pixelColor(3, 60); };
    for (const char* scheme : {"lightColours", "darkColours"}) {
      child<QAction>(scheme)->trigger();
      QTRY_COMPARE_WITH_TIMEOUT(cornerOf(), tokens().canvas, patience);
      const std::size_t front =
          std::size_t(std::ranges::find_if(rows(), &TradeoffRow::isPareto) - rows().begin());
      QVERIFY(front < rows().size());
      QCOMPARE(table()->item(0, 0)->foreground().color(), tokens().text);  // the fastest
    }
    // A file is for print, whatever the window looks like.
    QCOMPARE(printColours().background, QColor(Qt::white));
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestTradeoffDock>(argc, argv);
}
#include "test_tradeoff_dock.moc"

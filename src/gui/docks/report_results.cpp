// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/report_results.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "chart/plot_painting.h"
#include "core/base/text.h"
#include "gui/docks/chart_colours.h"

namespace hogelscope {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

/// Returns a cell with a number. A problem or an unknown number sorts first.
QStandardItem* numberCell(const QString& shown, double value) {
  auto* item = new QStandardItem(shown);
  item->setEditable(false);
  item->setData(std::isnan(value) ? -std::numeric_limits<double>::infinity() : value, sortRole);
  item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return item;
}

QStandardItem* nameCell(const QString& shown, const QString& help) {
  auto* item = new QStandardItem(shown);
  item->setEditable(false);
  item->setData(shown, sortRole);
  item->setToolTip(help);
  return item;
}

QStandardItem* metricCell(const ReportData& data, std::size_t row, std::size_t column) {
  if (data.isAwaited(row)) return numberCell({}, unknown);
  const ReportRow& own = data.rows[row];
  const double value = own.problem.empty() ? own.values[column] : unknown;
  return numberCell(text(tableText(data.metrics.columns()[column], value)), value);
}

/// Sets titles of columns and their tooltips.
void setHeadings(QStandardItemModel& model,
                 const std::vector<std::pair<QString, QString>>& headings) {
  model.setRowCount(0);
  model.setColumnCount(int(headings.size()));
  for (int column = 0; const auto& [title, help] : headings) {
    auto* item = new QStandardItem(title);
    item->setToolTip(help);
    item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    model.setHorizontalHeaderItem(column++, item);
  }
}

/// Returns the metrics of plugins that the window shows.
std::vector<std::size_t> moreColumns(const MetricSet& metrics) {
  std::vector<std::size_t> more;
  for (std::size_t k = mseOfBitsColumn + 1; k < metrics.columns().size(); ++k)
    if (metrics.columns()[k].where == MetricColumn::Where::window) more.push_back(k);
  return more;
}

double shareOf(const Axis& range, double value) {
  return range.high > range.low ? std::clamp(range.at(value), 0.0, 1.0) : 1;
}

QPixmap seriesMark(std::size_t series) {
  constexpr int side = 12, sharpness = 3;
  return pixmapOf(scaled(side), sharpness, [series](QPainter& painter, const QSizeF& size) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(tokens().series.at(series % tokens().series.size()));
    const double half = size.width() / 2;
    paintMark(painter, {half, half}, 0.6 * half, series);
  });
}

/// Returns a link to a state, such as "Fig 5  25.9".
QStandardItem* linkCell(const ReportData& data, std::size_t test, bool isBest) {
  const std::optional<std::size_t> state = data.extreme(test, isBest);
  if (!state) return numberCell("–", unknown);
  const std::size_t row = data.order().row(*state, test);
  auto* item = numberCell(text(viewName(data.rows[row]) + "  " + rounded(data.psnr(row), 1)),
                          data.psnr(row));
  item->setForeground(tokens().focus);
  item->setToolTip(QObject::tr("Shows this state and compares it in the view"));
  return item;
}

/// Returns the value of more than half of the states; NaN if there is none.
double usualOf(const std::vector<CameraState>& states, const auto& value) {
  std::map<double, std::size_t> counts;
  for (const CameraState& state : states)
    if (2 * ++counts[value(state)] > states.size()) return value(state);
  return unknown;
}

/// Returns a cell of a state's setting, which is orange if it differs from the usual one.
QStandardItem* settingCell(double own, double usual) {
  auto* item = numberCell(text(numberText(fourDigits(own))), own);
  if (std::isnan(usual) || own == usual) return item;
  item->setForeground(tokens().eye);
  item->setFont(textFont(TextSize::base, QFont::DemiBold));
  item->setToolTip(QObject::tr("Most states have %1").arg(text(numberText(fourDigits(usual)))));
  return item;
}

}  // namespace

void TestTable::fill(const ReportData& data) {
  setHeadings(*this, {{tr("Test"), tr("The test light field")},
                      {tr("bits/px"), tr("Bits of its files per directional pixel")},
                      {tr("PSNR, dB"), tr("Mean of the finite PSNRs over what is seen")},
                      {tr("worst – mean, 95 % – best"),
                       tr("From the worst to the best PSNR, with the mean and its 95 % interval")},
                      {tr("SSIM"), tr("Mean over what is seen")},
                      {tr("Worst"), tr("The state with the lowest PSNR")},
                      {tr("Best"), tr("The state with the highest PSNR")}});
  for (std::size_t test = 0; test < data.tests.size(); ++test) fill(data, test);
}

void TestTable::fill(const ReportData& data, std::size_t test) {
  const int row = int(test);
  const PlottedTest& plotted = data.plotted[test];
  const std::vector<std::string> curves = curvesOf(data.plotted);
  const ReportSummary summary = data.summaryOf(test);
  const double mean = summary.means[meanPsnrSeen];
  const double similarity = summary.means[meanSsimSeen];
  auto* title = nameCell(text(plotted.name), text(data.tests[test]));
  title->setData(seriesMark(std::size_t(std::ranges::find(curves, plotted.curve) - curves.begin())),
                 Qt::DecorationRole);
  setItem(row, name, title);
  setItem(row, rate, numberCell(text(rounded(plotted.rate, 2)), plotted.rate));
  setItem(row, psnr, numberCell(text(rounded(mean, 2)), mean));
  item(row, psnr)->setFont(textFont(TextSize::base, QFont::DemiBold));
  setItem(row, ssim, numberCell(text(rounded(similarity, 4)), similarity));
  setItem(row, worst, linkCell(data, test, false));
  setItem(row, best, linkCell(data, test, true));
  auto* span = numberCell({}, mean);
  if (!std::isnan(mean)) {
    const Axis all = data.range();
    const Axis range = data.range(test);
    const Interval interval = data.summaries.empty() ? Interval{mean, mean}
                                                     : data.summaries[test].intervals[meanPsnrSeen];
    QVariantList shares;
    QStringList numbers;
    for (const double value : {range.low, range.high, interval.low, interval.high, mean}) {
      shares << shareOf(all, value);
      numbers << text(rounded(value, 2));
    }
    span->setData(shares, barRole);
    span->setData(QString("%1 – %5 (%3 … %4) – %2")
                      .arg(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]),
                  Qt::AccessibleTextRole);
  }
  setItem(row, bar, span);
}

void StateTable::fill(const ReportData& data, std::size_t test) {
  m_range = data.range(test);
  const std::vector<CameraState>& states = data.session.cameras;
  m_usualSigma = usualOf(states, [](const CameraState& state) { return state.psf.sigma; });
  m_usualWindow =
      usualOf(states, [](const CameraState& state) { return double(state.psf.windowSize); });
  const std::vector<MetricColumn>& columns = data.metrics.columns();
  std::vector<std::pair<QString, QString>> headings{
      {tr("State"), tr("The session's camera states")},
      {tr("PSNR, dB"), text(columns[psnrSeenColumn].help)},
      {tr("SSIM"), text(columns[ssimSeenColumn].help)},
      {tr("Seen, %"), text(columns[seenColumn].help)},
      {tr("σ, px"), tr("Width of the light leakage, in directional pixels")},
      {tr("Window"), tr("Pixels that leak across; 1: none, nothing averages")},
      {tr("Lens"), tr("Whether the camera's lens distorts")},
      {tr("Distance, m"), tr("From the eye to the panel's middle")},
      {tr("Angle, °"), tr("Of the eye from the panel's normal")}};
  for (const std::size_t k : moreColumns(data.metrics))
    headings.emplace_back(text(columns[k].title), text(columns[k].help));
  setHeadings(*this, headings);
  for (std::size_t state = 0; !data.tests.empty() && state < states.size(); ++state)
    fill(data, test, state);
}

void StateTable::fill(const ReportData& data, std::size_t test, std::size_t state) {
  const int at = int(state);
  const std::size_t index = data.order().row(state, test);
  const ReportRow& row = data.rows[index];
  const EyePlace eye = eyePlaceOf(data.session.display, row.eye);
  const bool isProblem = !row.problem.empty() && !data.isAwaited(index);
  setItem(at, name, nameCell(text(viewName(row)), text(isProblem ? row.problem : viewName(row))));
  auto* figure = metricCell(data, index, psnrSeenColumn);
  if (isProblem) {
    figure->setText(text(row.problem));
    figure->setToolTip(text(row.problem));
  }
  if (std::isfinite(data.psnr(index)))
    figure->setData(QVariantList{shareOf(m_range, data.psnr(index))}, barRole);
  setItem(at, psnr, figure);
  setItem(at, ssim, metricCell(data, index, ssimSeenColumn));
  setItem(at, seen, metricCell(data, index, seenColumn));
  const CameraState& camera = data.session.cameras[state];
  setItem(at, sigma, settingCell(camera.psf.sigma, m_usualSigma));
  setItem(at, window, settingCell(camera.psf.windowSize, m_usualWindow));
  const bool hasLens = !camera.distortion.isPinhole();
  setItem(at, lens, numberCell(hasLens ? tr("yes") : "–", hasLens ? 1 : 0));
  setItem(at, distance, numberCell(text(rounded(eye.distance, 3)), eye.distance));
  setItem(at, angle, numberCell(text(rounded(eye.angle, 1)), eye.angle));
  for (int next = plugins; const std::size_t k : moreColumns(data.metrics))
    setItem(at, next++, metricCell(data, index, k));
}

RowFilter StateTable::filterOf(const QString& text) const {
  QStringList columns;
  for (int k = 1; k < columnCount(); ++k)
    columns << headerData(k, Qt::Horizontal).toString().section(',', 0, 0);
  return rowFilter(text, columns);
}

double StateTable::numberOf(int row, std::size_t k) const {
  const double value = index(row, int(k) + 1).data(ReportRole::sortRole).toDouble();
  return std::isinf(value) && value < 0 ? unknown : value;
}

void BarDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const {
  QStyledItemDelegate::paint(painter, option, index);
  const QVariantList bar = index.data(barRole).toList();
  if (bar.isEmpty()) return;
  const bool isTest = bar.size() > 1;
  const int width = isTest ? option.rect.width() - scaled(24) : scaled(42);
  const double left = option.rect.left() + scaled(12);
  const double middle = option.rect.center().y() + 0.5;
  const auto paintSpan = [&](double from, double to, double height, const QColor& colour) {
    painter->setBrush(colour);
    painter->drawRoundedRect(
        QRectF(left + from * width, middle - height / 2, (to - from) * width, height), height / 2,
        height / 2);
  };
  const auto share = [&bar](int k) { return bar[k].toDouble(); };
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(Qt::NoPen);
  if (isTest) {
    paintSpan(share(0), share(1), 2, tokens().strongLine);
    paintSpan(share(2), share(3), 4, tokens().text3);
    painter->setBrush(tokens().text);
    painter->drawEllipse(QPointF(left + share(4) * width, middle), scaled(4), scaled(4));
  } else {
    paintSpan(0, 1, scaled(4), tokens().line);
    paintSpan(0, share(0), scaled(4), shadeColour(share(0)));
  }
  painter->restore();
}

/// Colours that say something stay in selected rows.
void BarDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const QVariant colour = index.data(Qt::ForegroundRole);
  if (colour.isValid()) option->palette.setBrush(QPalette::HighlightedText, colour.value<QBrush>());
}

CopyTable::CopyTable(QWidget* parent) : QTableView(parent) {
  setMinimumHeight(scaled(52));
  setShowGrid(false);
  setSelectionBehavior(SelectRows);
  setItemDelegate(new BarDelegate(this));
  setHorizontalScrollMode(ScrollPerPixel);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(scaled(26));
  horizontalHeader()->setHighlightSections(false);
}

void CopyTable::copy(bool isAll) {
  Table table;
  const auto addLine = [&](const auto& textOf) {
    std::vector<std::string>& cells = table.emplace_back();
    for (int k = 0; k < model()->columnCount(); ++k) {
      const int column = horizontalHeader()->logicalIndex(k);
      if (!isColumnHidden(column)) cells.push_back(textOf(column).toString().toStdString());
    }
  };
  addLine([&](int column) { return model()->headerData(column, Qt::Horizontal); });
  const bool hasSelection = !isAll && selectionModel()->hasSelection();
  for (int row = 0; row < model()->rowCount(); ++row)
    if (!hasSelection || selectionModel()->isRowSelected(row, QModelIndex()))
      addLine([&](int column) {
        const QModelIndex index = model()->index(row, column);
        const QVariant accessible = index.data(Qt::AccessibleTextRole);
        return accessible.isValid() ? accessible : index.data();
      });
  QApplication::clipboard()->setText(text(csvText(table)));
}

bool CopyTable::event(QEvent* event) {
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (!isKey || !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy))
    return QTableView::event(event);
  if (event->type() == QEvent::KeyPress) copy(false);
  event->accept();
  return true;
}

}  // namespace hogelscope

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

#include "chart/plot_painting.h"
#include "core/base/colour_map.h"
#include "core/base/text.h"
#include "gui/widgets/colours.h"

namespace hogelscope {

namespace {

constexpr const char* notYet = "not compared yet";
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

QStandardItem* metricCell(const ReportData& data, const ReportRow& row, std::size_t column) {
  if (row.problem == notYet) return numberCell({}, unknown);
  const double value = row.problem.empty() ? row.values[column] : unknown;
  return numberCell(text(tableText(data.metrics.columns()[column], value)), value);
}

void setHeader(QStandardItemModel& model, int column, const QString& title, const QString& help) {
  auto* item = new QStandardItem(title);
  item->setToolTip(help);
  item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  model.setHorizontalHeaderItem(column, item);
}

/// Returns the range of the finite PSNRs of a test, or of all, with bars from 0 to 1.
Axis rangeOf(const ReportData& data, std::size_t first, std::size_t step) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Axis range{infinite, -infinite, 0, 1};
  for (std::size_t row = first; row < data.rows.size(); row += step)
    if (const double psnr = data.psnr(row); std::isfinite(psnr)) {
      range.low = std::min(range.low, psnr);
      range.high = std::max(range.high, psnr);
    }
  return range;
}

double shareOf(const Axis& range, double value) {
  return range.high > range.low ? std::clamp(range.at(value), 0.0, 1.0) : 1;
}

QPixmap markOf(std::size_t series) {
  constexpr int side = 12, sharpness = 3;
  QPixmap pixmap(sharpness * scaled(side), sharpness * scaled(side));
  pixmap.setDevicePixelRatio(sharpness);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(tokens().series.at(series % tokens().series.size()));
  const double half = scaled(side) / 2.0;
  paintMark(painter, {half, half}, 0.6 * half, series);
  return pixmap;
}

/// Returns a link to a state, such as "Fig 5  25.9".
QStandardItem* linkCell(const ReportData& data, std::size_t test, bool isBest) {
  const std::optional<std::size_t> state = data.extreme(test, isBest);
  if (!state) return numberCell("–", unknown);
  const std::size_t row = data.order().row(*state, test);
  auto* item =
      numberCell(text(data.rows[row].state + "  " + rounded(data.psnr(row), 1)), data.psnr(row));
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

QStringList shortNames(const std::vector<std::string>& files) {
  std::vector<QStringList> paths;
  for (const std::string& file : files) paths.push_back(text(file).split('/', Qt::SkipEmptyParts));
  QStringList names;
  for (const QStringList& path : paths) {
    qsizetype parts = 1;
    const auto isShared = [&](const QStringList& other) {
      return other != path && other.mid(other.size() - parts) == path.mid(path.size() - parts);
    };
    while (parts < path.size() && std::ranges::any_of(paths, isShared)) ++parts;
    const QStringList tail = path.mid(path.size() - parts);
    names << (parts < 3 ? tail.join('/') : tail.first() + "/…/" + tail.last());
  }
  return names;
}

void ReportData::begin() {
  const QStringList names = shortNames(tests);
  plotted.clear();
  for (const QString& name : names) {
    const qsizetype dot = name.lastIndexOf('.');
    QString curve = dot > 0 ? name.mid(dot + 1) : name;
    while (dot <= 0 && !curve.isEmpty() && !curve.back().isLetter()) curve.chop(1);
    plotted.push_back({name.toStdString(), curve.toStdString(), unknown});
  }
  rows.clear();
  for (const CameraState& state : session.cameras)
    for (const std::string& test : tests)
      rows.push_back({state.camera.name, test, metrics.noValues(), state.camera.eye, 1, notYet});
}

double ReportData::psnr(std::size_t row) const {
  return rows[row].problem.empty() ? rows[row].values[psnrSeenColumn] : unknown;
}

std::optional<std::size_t> ReportData::extreme(std::size_t test, bool isBest) const {
  std::optional<std::size_t> found;
  for (std::size_t row = test; row < rows.size(); row += tests.size()) {
    if (std::isnan(psnr(row))) continue;
    const double least = found ? psnr(order().row(*found, test)) : psnr(row);
    if (!found || (isBest ? psnr(row) > least : psnr(row) < least)) found = order().state(row);
  }
  return found;
}

void TestTable::fill(const ReportData& data) {
  setRowCount(0);
  const QStringList titles{
      tr("Test"), tr("bits/px"), tr("PSNR, dB"), tr("worst – mean, 95 % – best"),
      tr("SSIM"), tr("Worst"),   tr("Best")};
  const QStringList help{tr("The test light field"),
                         tr("Bits of its files per directional pixel"),
                         tr("Mean of the finite PSNRs over what is seen"),
                         tr("From the worst to the best PSNR, with the mean and its 95 % interval"),
                         tr("Mean over what is seen"),
                         tr("The state with the lowest PSNR"),
                         tr("The state with the highest PSNR")};
  for (int k = 0; k < titles.size(); ++k) setHeader(*this, k, titles[k], help[k]);
  for (std::size_t test = 0; test < data.tests.size(); ++test) fill(data, test);
}

void TestTable::fill(const ReportData& data, std::size_t test) {
  const int row = int(test);
  const PlottedTest& plotted = data.plotted[test];
  const std::vector<std::string> curves = curvesOf(data.plotted);
  std::vector<ReportRow> own;
  for (std::size_t k = test; k < data.rows.size(); k += data.tests.size())
    own.push_back(data.rows[k]);
  const ReportSummary summary = summariseRows(own, data.metrics);
  const double mean = summary.means[meanPsnrSeen];
  const double similarity = summary.means[meanSsimSeen];
  auto* title = nameCell(text(plotted.name), text(data.tests[test]));
  title->setData(markOf(std::size_t(std::ranges::find(curves, plotted.curve) - curves.begin())),
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
    const Axis all = rangeOf(data, 0, 1);
    const Axis range = rangeOf(data, test, data.tests.size());
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
  setRowCount(0);
  m_range = rangeOf(data, test, std::max<std::size_t>(1, data.tests.size()));
  const std::vector<CameraState>& states = data.session.cameras;
  m_usualSigma = usualOf(states, [](const CameraState& state) { return state.psf.sigma; });
  m_usualWindow =
      usualOf(states, [](const CameraState& state) { return double(state.psf.windowSize); });
  const std::vector<MetricColumn>& columns = data.metrics.columns();
  setHeader(*this, name, tr("State"), tr("The session's camera states"));
  setHeader(*this, psnr, tr("PSNR, dB"), text(columns[psnrSeenColumn].help));
  setHeader(*this, ssim, tr("SSIM"), text(columns[ssimSeenColumn].help));
  setHeader(*this, seen, tr("Seen, %"), text(columns[seenColumn].help));
  setHeader(*this, sigma, tr("σ, px"), tr("Width of the light leakage, in directional pixels"));
  setHeader(*this, window, tr("Window"), tr("Pixels that leak across; 1: none, nothing averages"));
  setHeader(*this, lens, tr("Lens"), tr("Whether the camera's lens distorts"));
  setHeader(*this, distance, tr("Distance, m"), tr("From the eye to the panel's middle"));
  setHeader(*this, angle, tr("Angle, °"), tr("Of the eye from the panel's normal"));
  int next = plugins;
  for (std::size_t k = mseOfBitsColumn + 1; k < columns.size(); ++k)
    if (columns[k].where == MetricColumn::Where::window)
      setHeader(*this, next++, text(columns[k].title), text(columns[k].help));
  setColumnCount(next);
  for (std::size_t state = 0; !data.tests.empty() && state < states.size(); ++state)
    fill(data, test, state);
}

void StateTable::fill(const ReportData& data, std::size_t test, std::size_t state) {
  const int at = int(state);
  const std::size_t index = data.order().row(state, test);
  const ReportRow& row = data.rows[index];
  const EyePlace eye = eyePlaceOf(data.session.display, row.eye);
  const bool isProblem = !row.problem.empty() && row.problem != notYet;
  setItem(at, name, nameCell(text(row.state), text(isProblem ? row.problem : row.state)));
  auto* figure = metricCell(data, row, psnrSeenColumn);
  if (isProblem) {
    figure->setText(text(row.problem));
    figure->setToolTip(text(row.problem));
  }
  if (std::isfinite(data.psnr(index)))
    figure->setData(QVariantList{shareOf(m_range, data.psnr(index))}, barRole);
  setItem(at, psnr, figure);
  setItem(at, ssim, metricCell(data, row, ssimSeenColumn));
  setItem(at, seen, metricCell(data, row, seenColumn));
  const CameraState& camera = data.session.cameras[state];
  setItem(at, sigma, settingCell(camera.psf.sigma, m_usualSigma));
  setItem(at, window, settingCell(camera.psf.windowSize, m_usualWindow));
  const bool hasLens = camera.distortion != DistortionParams();
  setItem(at, lens, numberCell(hasLens ? tr("yes") : "–", hasLens ? 1 : 0));
  setItem(at, distance, numberCell(text(rounded(eye.distance, 3)), eye.distance));
  setItem(at, angle, numberCell(text(rounded(eye.angle, 1)), eye.angle));
  int next = plugins;
  for (std::size_t k = mseOfBitsColumn + 1; k < data.metrics.columns().size(); ++k)
    if (data.metrics.columns()[k].where == MetricColumn::Where::window)
      setItem(at, next++, metricCell(data, row, k));
}

void StateFilter::setText(const QString& text) {
  std::vector<std::string> columns;
  for (int k = 1; k < sourceModel()->columnCount(); ++k)
    columns.push_back(sourceModel()
                          ->headerData(k, Qt::Horizontal)
                          .toString()
                          .section(',', 0, 0)
                          .toLower()
                          .toStdString());
  m_filter = RowFilter(text.toLower().toStdString(), columns);
  invalidateFilter();
}

bool StateFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const auto at = [&](int column) { return sourceModel()->index(row, column, parent); };
  return m_filter.accepts(at(0).data().toString().toLower().toStdString(), [&](std::size_t k) {
    const double value = at(int(k) + 1).data(ReportRole::sortRole).toDouble();
    return std::isinf(value) && value < 0 ? unknown : value;
  });
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
    const auto [r, g, b] = falseColour(share(0));
    paintSpan(0, 1, scaled(4), tokens().line);
    paintSpan(0, share(0), scaled(4), QColor(r, g, b));
  }
  painter->restore();
}

/// Colours that say something stay in selected rows.
void BarDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const QVariant colour = index.data(Qt::ForegroundRole);
  if (colour.isValid()) option->palette.setBrush(QPalette::HighlightedText, colour.value<QBrush>());
}

CopyTable::CopyTable(const QString& name) {
  setObjectName(name);
  setShowGrid(false);
  setSelectionBehavior(SelectRows);
  setItemDelegate(new BarDelegate(this));
  setHorizontalScrollMode(ScrollPerPixel);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(scaled(26));
  horizontalHeader()->setHighlightSections(false);
}

void CopyTable::copy(bool isAll) {
  QStringList lines;
  const auto addLine = [&](const auto& textOf) {
    QStringList cells;
    for (int k = 0; k < model()->columnCount(); ++k) {
      const int column = horizontalHeader()->logicalIndex(k);
      if (!isColumnHidden(column)) cells << text(csvCell(textOf(column).toString().toStdString()));
    }
    lines << cells.join(',') + '\n';
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
  QApplication::clipboard()->setText(lines.join(""));
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

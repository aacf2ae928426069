// SPDX-License-Identifier: BSD-3-Clause
#include "chart/painting.h"

#include <QBuffer>
#include <QImage>
#include <QSvgGenerator>
#include <QTemporaryDir>
#include <cmath>
#include <cstdio>

#include "core/base/colour_map.h"

namespace hogelscope {

namespace {

QFont chartFont() {
  QFont font;
  font.setFamilies({"DejaVu Sans", "Liberation Sans", "sans-serif"});
  font.setPixelSize(12);
  return font;
}

void onlyFatal(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtFatalMsg) std::fprintf(stderr, "hogelscope: %s\n", qPrintable(message));
}

void paintOn(QPaintDevice& device, const Paint& paint, const QSize& size) {
  QPainter painter(&device);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(chartFont());
  painter.fillRect(QRect({0, 0}, size), printColours().background);
  paint(painter, size);
}

}  // namespace

QColor shadeColour(double share) {
  const auto [r, g, b] = falseColour(share);
  return {r, g, b};
}

const ChartColours& printColours() {
  static const ChartColours colours{.background = Qt::white,
                                    .text = 0x1c1f23,
                                    .text2 = 0x565c65,
                                    .line = 0xb4b9c0,
                                    .grid = 0xe4e6e9,
                                    .accent = 0x0b66d8,
                                    .series = {0x0072b2, 0xc46f00, 0x007f5f, 0xa8457f}};
  return colours;
}

OffscreenPainting::OffscreenPainting() {
  if (QCoreApplication::instance() != nullptr) return;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  // Without XDG_RUNTIME_DIR, which batch machines do not have, Qt makes a folder with a predictable
  // name in /tmp and warns. It looks into it only here.
  const QTemporaryDir folder;
  const bool isMissing = qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR");
  if (isMissing) qputenv("XDG_RUNTIME_DIR", folder.path().toLocal8Bit());
  const QtMessageHandler before = qInstallMessageHandler(onlyFatal);
  m_application.emplace(m_argc, m_argv);
  qInstallMessageHandler(before);
  if (isMissing) qunsetenv("XDG_RUNTIME_DIR");
}

std::string pngOf(const Paint& paint, const QSize& size) {
  constexpr int scale = 2;
  QImage image(scale * size, QImage::Format_RGB32);
  image.setDevicePixelRatio(scale);
  paintOn(image, paint, size);
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data().toStdString();
}

std::string svgOf(const Paint& paint, const QSize& size, const std::string& title,
                  double millimetres) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(size);
  generator.setViewBox(QRect({0, 0}, size));
  constexpr double inch = 25.4;
  generator.setResolution(millimetres > 0 ? int(std::lround(size.width() * inch / millimetres))
                                          : 108);  // pixels per inch: 2/3 pt
  generator.setTitle(QString::fromStdString(title));
  paintOn(generator, paint, size);
  return buffer.data().toStdString();
}

}  // namespace hogelscope

// SPDX-License-Identifier: BSD-3-Clause
#include "chart/painting.h"

#include <QBuffer>
#include <QImage>
#include <QSvgGenerator>
#include <cstdio>

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
  painter.fillRect(QRect({0, 0}, size), Qt::white);
  paint(painter, size);
}

}  // namespace

OffscreenPainting::OffscreenPainting() {
  if (QCoreApplication::instance() != nullptr) return;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  // Suppresses Qt's warning of a missing XDG_RUNTIME_DIR, which batch machines do not need.
  const QtMessageHandler before = qInstallMessageHandler(onlyFatal);
  m_application.emplace(m_argc, m_argv);
  qInstallMessageHandler(before);
}

std::string pngOf(const Paint& paint, const QSize& size) {
  constexpr int pixelsPerPoint = 2;
  QImage image(pixelsPerPoint * size, QImage::Format_RGB32);
  image.setDevicePixelRatio(pixelsPerPoint);
  paintOn(image, paint, size);
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data().toStdString();
}

std::string svgOf(const Paint& paint, const QSize& size, const std::string& title) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(size);
  generator.setViewBox(QRect({0, 0}, size));
  generator.setResolution(72);  // one unit per point
  generator.setTitle(QString::fromStdString(title));
  paintOn(generator, paint, size);
  return buffer.data().toStdString();
}

}  // namespace hogelscope

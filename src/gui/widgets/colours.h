// SPDX-License-Identifier: BSD-3-Clause
// The window's look: its colours, from which palette, style sheet and painters take theirs (no
// other file names a colour of the window), its fonts and its icons; the menus that choose the
// scheme of colours and the size of text.
#pragma once

#include <QColor>
#include <QFont>
#include <QIcon>
#include <array>

class QMenu;
class QPainter;

namespace hogelscope {

/// The colours of a scheme.
struct Tokens {
  QColor window;         ///< bars and docks
  QColor canvas;         ///< behind scene, simulated view and plots
  QColor field;          ///< behind editable values and lists
  QColor raised, hover;  ///< buttons; with the pointer on them
  QColor line, strongLine;
  QColor text, text2, text3;  ///< text3: units, captions, hints; not on `raised` or `selection`
  QColor focus, primary;      ///< the focused field; the button that goes on
  QColor selection, selectionText;
  QColor eye;  ///< the current eye; on light backgrounds for marks only, as `good`
  QColor good, amber, error;
  std::array<QColor, 3> axes;    ///< x, y, z
  std::array<QColor, 4> series;  ///< of charts, in the order circle, square, triangle, diamond
  QColor grid;                   ///< of charts
};

/// Returns the colours of the scheme in use. Widgets get a PaletteChange event when it changes.
const Tokens& tokens();
/// Returns the colours of the light scheme, which figures on paper have.
const Tokens& lightTokens();

/// The sizes of text.
enum class TextSize {
  caption = 11,  ///< captions, units, ticks
  base = 13,
  title = 15,   ///< of cards
  number = 16,  ///< derived numbers
};
/// Returns the system's font at a size of text, scaled as the user chose.
QFont textFont(TextSize size, QFont::Weight weight = QFont::Normal);
/// Returns a length that is `pixels` at the normal size of text, scaled as text is.
int scaled(int pixels);
/// Writes one line into `place`, with "…" where it is too long. Returns the place of the text.
QRect writeLine(QPainter& painter, const QRect& place, Qt::Alignment side, const QString& text,
                const QFont& font, const QColor& ink, Qt::TextElideMode cut = Qt::ElideRight);

/// Returns the icon of resources/icons/NAME.svg, painted in the palette's text colour.
QIcon icon(const QString& name);

/// Fills the menus of the schemes (dark, light, the system's) and of the size of text. Both choices
/// are saved in the settings and applied to the application and its windows, now and when they
/// change.
void addLook(QMenu* colours, QMenu* sizes);

}  // namespace hogelscope

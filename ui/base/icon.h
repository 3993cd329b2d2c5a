// Icons from alpha masks, tinted with the theme's colours when they are drawn: text, text at 38 %
// when disabled, accent when checked.
#pragma once

#include <QIcon>

namespace fff::ui {

/// `name` as in resources/icons, without ending.
QIcon themedIcon(const QString &name);

/// For rows of lists: muted, and readable on the selection.
QIcon rowIcon(const QString &name);

/// In this colour, and readable on the selection.
QIcon colouredIcon(const QString &name, const QColor &colour);

/// One picture of it in one colour. `size` in device-independent pixels.
QPixmap tintedPixmap(const QString &name, int size, const QColor &colour, double pixelRatio);

} // namespace fff::ui

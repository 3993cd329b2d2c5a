// What colour words have and what they stand on, measured on the pixels of what is shown.
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QGroupBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QTabBar>
#include <QToolButton>
#include <QWidget>

#include <map>
#include <optional>
#include <vector>

namespace fff::test {

struct ShownInk
{
    const QWidget *widget = nullptr;
    QString text;
    QColor words, ground;
};

/// Pixels of the picture to one of the window: stems of letters are wider than what smooths them.
constexpr int kInkScale = 3;

/// The colour that most of it has, and of the others that which most has whose neighbours have it,
/// too: what smooths an edge is between the two. None: there is one colour alone.
inline std::optional<std::pair<QColor, QColor>> groundAndInk(const QImage &image,
                                                             const QRect &place)
{
    std::map<QRgb, int> all, solid;
    const QRect inner = place.intersected(image.rect()).adjusted(1, 1, -1, -1);
    for (int y = inner.top(); y <= inner.bottom(); ++y)
        for (int x = inner.left(); x <= inner.right(); ++x) {
            const QRgb pixel = image.pixel(x, y);
            ++all[pixel];
            if (image.pixel(x - 1, y) == pixel && image.pixel(x + 1, y) == pixel &&
                image.pixel(x, y - 1) == pixel && image.pixel(x, y + 1) == pixel)
                ++solid[pixel];
        }
    const auto more = [](const auto &a, const auto &b) { return a.second < b.second; };
    const auto ground = std::max_element(all.begin(), all.end(), more);
    if (ground == all.end())
        return std::nullopt;
    solid.erase(ground->first);
    const auto ink = std::max_element(solid.begin(), solid.end(), more);
    if (ink == solid.end() || ink->second < kInkScale * kInkScale)
        return std::nullopt;
    return std::pair(QColor(ground->first), QColor(ink->first));
}

/// Of what is in sight under `top` and can be used: labels, buttons, fields, tabs and rows.
inline std::vector<ShownInk> inkOf(QWidget &top)
{
    QImage image(top.size() * kInkScale, QImage::Format_RGB32);
    image.setDevicePixelRatio(kInkScale);
    top.render(&image);
    image.setDevicePixelRatio(1.0);
    std::vector<ShownInk> found;
    const auto measure = [&](const QWidget &widget, QRect place, const QString &text) {
        // As far as what holds it shows it.
        for (const QWidget *of = &widget; of && of != &top; of = of->parentWidget()) {
            place &= of->rect();
            place.translate(of->pos());
        }
        place &= top.rect();
        if (text.trimmed().isEmpty() || place.width() < 6 || place.height() < 8)
            return;
        const auto colours =
            groundAndInk(image, {place.topLeft() * kInkScale, place.size() * kInkScale});
        if (colours)
            found.push_back({&widget, text, colours->second, colours->first});
    };
    for (const QWidget *widget : top.findChildren<QWidget *>()) {
        if (!widget->isVisible() || !widget->isEnabled() || widget->window() != top.window())
            continue;
        const QRect inner = widget->rect().adjusted(3, 3, -3, -3); // without its frame
        if (const auto *label = qobject_cast<const QLabel *>(widget)) {
            measure(*widget, label->contentsRect(), label->text());
        } else if (const auto *tool = qobject_cast<const QToolButton *>(widget)) {
            if (tool->toolButtonStyle() != Qt::ToolButtonIconOnly)
                measure(*widget, inner, tool->text());
        } else if (const auto *button = qobject_cast<const QAbstractButton *>(widget)) {
            measure(*widget, inner, button->text());
        } else if (const auto *box = qobject_cast<const QComboBox *>(widget)) {
            measure(*widget, inner.adjusted(0, 0, -20, 0), box->currentText());
        } else if (const auto *line = qobject_cast<const QLineEdit *>(widget)) {
            measure(*widget, inner,
                    line->text().isEmpty() ? line->placeholderText() : line->text());
        } else if (const auto *tabs = qobject_cast<const QTabBar *>(widget)) {
            for (int i = 0; i < tabs->count(); ++i)
                measure(*widget, tabs->tabRect(i).adjusted(4, 4, -4, -4), tabs->tabText(i));
        } else if (const auto *view = qobject_cast<const QAbstractItemView *>(widget)) {
            const QAbstractItemModel *model = view->model();
            const QModelIndex root = view->rootIndex();
            for (int row = 0; model && row < std::min(20, model->rowCount(root)); ++row)
                for (int column = 0; column < model->columnCount(root); ++column) {
                    const QModelIndex cell = model->index(row, column, root);
                    if (cell.flags().testFlag(Qt::ItemIsEnabled))
                        measure(*view->viewport(), view->visualRect(cell).adjusted(2, 2, -2, -2),
                                cell.data().toString());
                }
        }
    }
    return found;
}

} // namespace fff::test

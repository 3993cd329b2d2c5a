#include "ui/dialogs/offcut_rows.h"

#include "core/model/spare_sheet.h"
#include "ui/base/icon.h"
#include "ui/bench/measures.h"
#include "ui/properties/length_edit.h"
#include "ui/properties/number_edit.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace fff::ui {

namespace {

constexpr LengthEdit::Range kSide{1.0, 10000.0, 10.0, 0, 1}; // mm
constexpr NumberEdit::Range kCount{1.0, 999.0, 1.0, 0, 0};
constexpr int kSideWidth = 66, kCountWidth = 54, kLeastWidth = 290; // px
const Vec2 kFirst(300.0, 200.0);                                    // mm, of one that is added

QToolButton *textButton(const QString &icon, const char *objectName, const QString &text,
                        QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setObjectName(QLatin1String(objectName));
    button->setIcon(themedIcon(icon));
    button->setIconSize({14, 14});
    button->setText(text);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

} // namespace

OffcutRows::OffcutRows(StockAccess stock, QWidget *parent)
    : QWidget(parent), m_stock(std::move(stock))
{
    setMinimumWidth(kLeastWidth); // also while there is none
    m_column = new QVBoxLayout(this);
    m_column->setContentsMargins(0, 2, 0, 4);
    m_column->setSpacing(6);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    m_addSize = textButton(QStringLiteral("plus"), "offcutAdd", tr("Offcut"), this);
    m_addSize->setToolTip(tr("A sheet of another size, which is used up before whole ones"));
    auto *drawing =
        textButton(QStringLiteral("open"), "offcutDrawing", tr("From a drawing…"), this);
    drawing->setToolTip(tr("What is left of a sheet, as the largest outline of an SVG file in true "
                           "size, with its holes"));
    buttons->addWidget(m_addSize);
    buttons->addWidget(drawing);
    buttons->addStretch(1);
    m_column->addLayout(buttons);
    m_said = new QLabel(this);
    m_said->setObjectName(QStringLiteral("offcutSaid"));
    m_said->setTextFormat(Qt::PlainText); // names of files are in it
    m_said->setWordWrap(true);
    m_said->setMinimumWidth(1);
    m_said->hide();
    m_column->addWidget(m_said);
    connect(m_addSize, &QToolButton::clicked, this, [this] { add(rectangularSheet(kFirst)); });
    connect(drawing, &QToolButton::clicked, this, &OffcutRows::drawingWanted);
}

void OffcutRows::add(Result<SpareSheet> sheet)
{
    say({});
    if (sheet)
        m_stock.edit([&](Stock &stock) { stock.spares.push_back(*sheet); });
}

void OffcutRows::focusAdd()
{
    m_addSize->setFocus(Qt::OtherFocusReason);
}

void OffcutRows::say(const QStringList &sentences)
{
    m_said->setText(sentences.join(u'\n'));
    m_said->setVisible(!sentences.isEmpty());
}

void OffcutRows::setSide(std::size_t index, int axis, double mm)
{
    m_stock.edit([&](Stock &stock) {
        if (index >= stock.spares.size())
            return;
        SpareSheet &spare = stock.spares[index];
        Vec2 size = spare.size();
        size[axis] = mm;
        if (auto next = rectangularSheet(size, spare.count))
            spare = *std::move(next);
    });
}

OffcutRows::Row OffcutRows::makeRow(std::size_t index)
{
    Row made;
    made.widget = new QWidget(this);
    auto *row = new QHBoxLayout(made.widget);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    for (const int axis : {0, 1}) {
        auto *side = made.sides[axis] = new LengthEdit(kSide, made.widget);
        side->setObjectName(
            (axis == 0 ? QStringLiteral("offcutWidth%1") : QStringLiteral("offcutHeight%1"))
                .arg(index + 1));
        side->setAccessibleName(axis == 0 ? tr("Width of the offcut") : tr("Height of the offcut"));
        side->setMinimumWidth(kSideWidth);
        connect(side, &LengthEdit::lengthEdited, this,
                [this, index, axis](double mm) { setSide(index, axis, mm); });
        row->addWidget(side, 1);
    }
    made.outline = new QLabel(made.widget);
    made.outline->setWordWrap(true);
    made.outline->setMinimumWidth(1);
    row->addWidget(made.outline, 1);
    auto *times = new QLabel(QStringLiteral("×"), made.widget);
    made.count = new NumberEdit(kCount, QString(), made.widget);
    made.count->setObjectName(QStringLiteral("offcutCount%1").arg(index + 1));
    made.count->setAccessibleName(tr("How many of this offcut"));
    made.count->setMinimumWidth(kCountWidth);
    connect(made.count, &NumberEdit::numberEdited, this, [this, index](double number) {
        m_stock.edit([&](Stock &stock) {
            if (index < stock.spares.size())
                stock.spares[index].count = static_cast<int>(std::lround(number));
        });
    });
    auto *remove = smallButton(QStringLiteral("trash"), "offcutRemove", tr("Take this offcut away"),
                               made.widget);
    remove->setObjectName(QStringLiteral("offcutRemove%1").arg(index + 1));
    connect(remove, &QToolButton::clicked, this, [this, index] {
        m_stock.edit([&](Stock &stock) {
            if (index < stock.spares.size())
                stock.spares.erase(stock.spares.begin() + static_cast<std::ptrdiff_t>(index));
        });
    });
    row->addWidget(times);
    row->addWidget(made.count);
    row->addWidget(remove);
    return made;
}

void OffcutRows::refresh()
{
    const std::vector<SpareSheet> &spares = m_stock.read()->spares;
    while (m_rows.size() < spares.size()) {
        m_rows.push_back(makeRow(m_rows.size()));
        m_column->insertWidget(m_column->count() - 2, m_rows.back().widget);
        m_rows.back().widget->show();
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row &row = m_rows[i];
        row.widget->setVisible(i < spares.size());
        if (i >= spares.size())
            continue;
        const std::optional<Vec2> rectangle = rectangleOf(spares[i]);
        const Vec2 size = spares[i].size();
        for (const int axis : {0, 1}) {
            row.sides[axis]->setVisible(rectangle.has_value());
            row.sides[axis]->setLength(size[axis]);
        }
        row.outline->setVisible(!rectangle);
        //: %1 is the size of the box of an offcut with an outline of its own
        row.outline->setText(
            tr("%1, from a drawing").arg(sizeText({size.x(), size.y()}, 0, locale())));
        row.count->setNumber(spares[i].count);
    }
}

} // namespace fff::ui

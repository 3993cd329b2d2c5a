#include "ui/properties/segmented_box.h"

#include "ui/view/heading_weight.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QToolButton>

namespace fff::ui {

namespace {

constexpr int kHeight = 26, kBeside = 6; // px

} // namespace

SegmentedBox::SegmentedBox(const QStringList &texts, QWidget *parent)
    : QWidget(parent), m_buttons(new QButtonGroup(this))
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    for (const QString &text : texts) {
        auto *button = new QToolButton(this);
        button->setObjectName(QStringLiteral("segment"));
        button->setText(text);
        button->setCheckable(true);
        button->setFixedHeight(kHeight);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setFocusPolicy(Qt::StrongFocus);
        // The frame that two share is drawn once.
        button->setProperty("segmentEnd", text == texts.back());
        m_buttons->addButton(button, static_cast<int>(m_buttons->buttons().size()));
        row->addWidget(button);
    }
    if (!texts.isEmpty())
        setFocusProxy(m_buttons->button(0));
    connect(m_buttons, &QButtonGroup::idClicked, this, &SegmentedBox::activated);
}

void SegmentedBox::setCurrent(int index)
{
    if (QAbstractButton *button = m_buttons->button(index)) {
        button->setChecked(true);
        setFocusProxy(button);
    } else if (QAbstractButton *checked = m_buttons->checkedButton()) {
        m_buttons->setExclusive(false);
        checked->setChecked(false);
        m_buttons->setExclusive(true);
    }
}

void SegmentedBox::setText(int index, const QString &text)
{
    if (QAbstractButton *button = m_buttons->button(index))
        button->setText(text);
}

int SegmentedBox::current() const
{
    return m_buttons->checkedId();
}

void SegmentedBox::setSpoken(const QString &name)
{
    for (QAbstractButton *button : m_buttons->buttons())
        //: %1 is the name of a choice ("Side"), %2 one of what can be chosen ("Both")
        button->setAccessibleName(tr("%1: %2").arg(name, button->text()));
}

int SegmentedBox::widthOf(const QStringList &texts, const QFont &font)
{
    QFont bold = font; // as the chosen one is
    bold.setWeight(headingWeight());
    int width = 0;
    for (const QString &text : texts)
        width += QFontMetrics(bold).horizontalAdvance(text) + 2 * kBeside;
    return width;
}

} // namespace fff::ui

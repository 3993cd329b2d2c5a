#include "ui/dialogs/parts_table.h"

#include "core/io/listing.h"
#include "ui/bench/measures.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QStyledItemDelegate>

namespace fff::ui {

namespace {

struct PartsTableTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::PartsTable)
};

enum PartColumn { NumberColumn, NameColumn, SizeColumn, AreaColumn, CountColumn };

/// With air between columns and lines.
class AiryRows : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        return QStyledItemDelegate::sizeHint(option, index) + QSize(18, 6);
    }
};

/// "3, 5–8"
QString rangesText(const std::vector<int> &numbers)
{
    QStringList ranges;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1)
            ++last;
        ranges += last == i ? QString::number(numbers[i])
                            : QStringLiteral("%1%2%3")
                                  .arg(numbers[i])
                                  .arg(last == i + 1 ? QStringLiteral(", ") : QStringLiteral("–"))
                                  .arg(numbers[last]);
        i = last + 1;
    }
    return separated(ranges);
}

} // namespace

PartsTable::PartsTable(QWidget *parent) : QTreeWidget(parent)
{
    setObjectName(QStringLiteral("partsTable"));
    setAccessibleName(PartsTableTexts::tr("Parts list"));
    setHeaderLabels({PartsTableTexts::tr("No."), PartsTableTexts::tr("Name"),
                     PartsTableTexts::tr("Size"), PartsTableTexts::tr("Area"),
                     PartsTableTexts::tr("Count")});
    setItemDelegate(new AiryRows(this));
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setTextElideMode(Qt::ElideMiddle);
    header()->setStretchLastSection(false);
    header()->setSectionsMovable(false);
    for (const int column : {NumberColumn, SizeColumn, AreaColumn, CountColumn})
        header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    for (const int column : {SizeColumn, AreaColumn, CountColumn})
        headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
}

void PartsTable::setParts(const std::vector<ListedPart> &parts)
{
    clear();
    QList<QTreeWidgetItem *> rows;
    for (const ListedPart &part : parts) {
        const QString name = QString::fromStdString(part.name);
        auto *row = new QTreeWidgetItem({rangesText(part.numbers), name,
                                         sizeText({part.size.x(), part.size.y()}, 1, locale()),
                                         areaText(part.area, locale()),
                                         locale().toString(static_cast<int>(part.numbers.size()))});
        row->setToolTip(NameColumn, name.toHtmlEscaped());
        for (const int column : {SizeColumn, AreaColumn, CountColumn})
            row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        rows += row;
    }
    addTopLevelItems(rows);
}

} // namespace fff::ui

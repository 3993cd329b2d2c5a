#include "ui/dialogs/export_place_row.h"

#include "ui/properties/link_row.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>

namespace fff::ui {

namespace {

QString nameOf(const QDir &folder)
{
    return folder.isRoot() ? folder.path() : folder.dirName();
}

} // namespace

ExportPlaceRow::ExportPlaceRow(QWidget *parent)
    : QWidget(parent), m_words(new QLabel(this)), m_change(new LinkRow(this))
{
    setObjectName(QStringLiteral("exportPlace"));
    m_words->setObjectName(QStringLiteral("exportPlaceWords"));
    m_words->setTextFormat(Qt::PlainText);
    m_words->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // it is cut short
    m_change->setObjectName(QStringLiteral("exportChangePlace"));
    m_change->setTexts({tr("Change…")});
    m_change->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 2, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_words, 1);
    row->addWidget(m_change);
    connect(m_change, &LinkRow::clicked, this, &ExportPlaceRow::changeWanted);
}

QString ExportPlaceRow::placeText(const QString &name, const QDir &folder)
{
    //: %1 is a file's name, or several, %2 their folder's
    return tr("%1 in %2").arg(name, nameOf(folder));
}

void ExportPlaceRow::setPath(const QString &path, bool isFirst)
{
    const QFileInfo file(path);
    m_text = isFirst ? tr("%1 and so on, in %2").arg(file.fileName(), nameOf(file.dir()))
                     : placeText(file.fileName(), file.dir());
    const QString whole = QDir::toNativeSeparators(path);
    m_words->setToolTip(whole);
    m_words->setAccessibleName(whole);
    refresh();
}

void ExportPlaceRow::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    refresh();
}

void ExportPlaceRow::refresh()
{
    layout()->activate();
    m_words->setText(m_words->fontMetrics().elidedText(m_text, Qt::ElideMiddle, m_words->width()));
}

} // namespace fff::ui

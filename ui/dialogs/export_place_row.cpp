#include "ui/dialogs/export_place_row.h"

#include "ui/properties/link_row.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace fff::ui {

namespace {

QString nameOf(const QDir &folder)
{
    if (folder == QDir::home()) // its name may be an account's
        return ExportPlaceRow::tr("your home folder");
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
    return textOf(name, nameOf(folder), Kind::New);
}

QString ExportPlaceRow::textOf(const QString &name, const QString &folder, Kind kind)
{
    switch (kind) {
    case Kind::New:
        //: %1 is a file's name, or several, %2 their folder's
        return tr("%1 in %2").arg(name, folder);
    case Kind::Replaced:
        //: %1 is the name of a file that is there, %2 its folder's
        return tr("Replaces %1 in %2").arg(name, folder);
    case Kind::First:
        return tr("%1 and so on, in %2").arg(name, folder);
    }
    return {}; // not reached: every kind is above
}

void ExportPlaceRow::setPath(const QString &path, bool isFirst)
{
    const QFileInfo file(path);
    m_name = file.fileName();
    m_folder = nameOf(file.dir());
    m_kind = isFirst ? Kind::First : file.isFile() ? Kind::Replaced : Kind::New;
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
    // Each loses its own middle, so that where one ends and the other begins stays to be read.
    const QFontMetrics metrics = m_words->fontMetrics();
    const int room = m_words->width() - metrics.horizontalAdvance(textOf({}, {}, m_kind)) - 2;
    const int folder = metrics.horizontalAdvance(m_folder);
    const QString name =
        metrics.elidedText(m_name, Qt::ElideMiddle, room - std::min(folder, room / 2));
    const QString rest =
        metrics.elidedText(m_folder, Qt::ElideMiddle, room - metrics.horizontalAdvance(name));
    m_words->setText(textOf(name, rest, m_kind));
}

} // namespace fff::ui

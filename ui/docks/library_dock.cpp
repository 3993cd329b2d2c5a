#include "ui/docks/library_dock.h"

#include "core/io/error_text.h"
#include "core/io/file_set.h"
#include "core/io/formats.h"
#include "core/operations/excerpt.h"
#include "ui/base/file_dialog.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"
#include "ui/cards/card_grid.h"
#include "ui/cards/model_card.h"
#include "ui/docks/dock_title.h"
#include "ui/settings/settings.h"

#include <QAction>
#include <QDir>
#include <QEvent>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QStandardPaths>
#include <QVBoxLayout>

namespace fff::ui {

namespace {

constexpr int kMargin = 12, kGap = 12; // px
const QString kFolderKey = QStringLiteral("library/folder");

/// As a file can be called in all systems.
QString fileName(const QString &name)
{
    static const QRegularExpression forbidden(QStringLiteral(R"([\x00-\x1f<>:"/\\|?*])"));
    QString safe = name;
    safe.replace(forbidden, QStringLiteral("_"));
    safe = safe.trimmed();
    while (safe.startsWith(u'.'))
        safe.remove(0, 1);
    return safe.isEmpty() ? LibraryDock::tr("Part") : safe;
}

QString suffix()
{
    return u'.' + io::nativeFormat().suffix();
}

QString freePath(const QDir &folder, const QString &name)
{
    QString path = folder.filePath(name + suffix());
    for (int i = 2; QFile::exists(path); ++i)
        path = folder.filePath(QStringLiteral("%1 %2").arg(name).arg(i) + suffix());
    return path;
}

} // namespace

LibraryDock::LibraryDock(Workbench &bench, QWidget *parent)
    : QDockWidget(tr("Library"), parent), m_bench(bench),
      m_thumbnails({ModelCard::kWidth, ModelCard::kPictureHeight})
{
    dressDock(this, "libraryDock");
    auto *content = new QWidget(this);
    auto *add = new QPushButton(tr("Add selection"), content);
    add->setObjectName(QStringLiteral("libraryAdd"));
    add->setToolTip(tr("Put the selection into the library; without one, the whole model"));
    connect(add, &QPushButton::clicked, this, &LibraryDock::addSelection);
    auto *choose = new QPushButton(tr("Folder…"), content);
    choose->setObjectName(QStringLiteral("libraryFolder"));
    choose->setToolTip(tr("Choose the folder whose models are shown here"));
    connect(choose, &QPushButton::clicked, this, &LibraryDock::chooseFolder);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(add, 1);
    buttons->addWidget(choose);

    m_empty = new QLabel(
        tr("Parts that you keep appear here: select some sections, then click Add selection."),
        content);
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    auto *page = new QWidget(content);
    m_grid = new CardGrid({ModelCard::kWidth, ModelCard::kHeight}, kGap, page);
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    column->addWidget(m_empty);
    column->addWidget(m_grid);
    column->addStretch();
    auto *scroll = new QScrollArea(content);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(page);

    auto *all = new QVBoxLayout(content);
    all->setContentsMargins(8, 8, 8, 0);
    all->addLayout(buttons);
    all->addWidget(scroll, 1);
    setWidget(content);

    connect(&m_thumbnails, &Thumbnails::ready, this,
            [this](const QString &path, const QImage &picture, int count) {
                const auto card = m_cards.find(path);
                if (card == m_cards.end())
                    return;
                card->second->setPicture(picture);
                card->second->setNote(tr("%n section(s)", nullptr, count));
            });
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &LibraryDock::fill);
}

QString LibraryDock::folder() const
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return settings().memory(kFolderKey).toString().isEmpty()
               ? QDir(documents).filePath(QStringLiteral("FlatFitFab library"))
               : settings().memory(kFolderKey).toString();
}

void LibraryDock::setFolder(const QString &folder)
{
    settings().setMemory(kFolderKey, folder);
    fill();
}

void LibraryDock::chooseFolder()
{
    FileDialog dialog(window(), tr("Library folder"), folder());
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
    if (dialog.exec() == QDialog::Accepted)
        setFolder(dialog.selectedFiles().constFirst());
}

void LibraryDock::addSelection()
{
    const Model &model = m_bench.session().committed();
    const std::vector<SectionRef> chosen = m_bench.interaction().sectionsInFocus();
    if (model.sectionCount() == 0) {
        Q_EMIT said(tr("Nothing added: nothing is drawn yet."));
        return;
    }
    const QString name = fileName(QString::fromStdString(
        chosen.empty() ? model.section(0)->name : model.nameOf(chosen.front())));
    const QDir place(folder());
    if (!place.mkpath(QStringLiteral("."))) {
        Q_EMIT failed(tr("The library folder %1 cannot be created.")
                          .arg(QDir::toNativeSeparators(place.path())));
        return;
    }
    const Result<std::string> bytes =
        io::nativeFormat().writeModel(chosen.empty() ? model.document : excerpt(model, chosen), {});
    const QString path = freePath(place, name);
    const Result<void> written =
        bytes ? io::writeFiles({{path, *bytes}}) : tl::unexpected(bytes.error());
    if (!written) {
        Q_EMIT failed(io::errorText(written.error()));
        return;
    }
    Q_EMIT said(tr("%1 is in the library now.").arg(QFileInfo(path).completeBaseName()));
    fill();
}

/// Into the wastebasket, from where it can be taken back.
void LibraryDock::remove(const QString &path)
{
    const QString name = QFileInfo(path).completeBaseName();
    if (QFile::moveToTrash(path))
        Q_EMIT said(tr("%1 is in the trash.").arg(name));
    else
        Q_EMIT failed(tr("%1 could not be moved to the trash.").arg(name));
    fill();
}

void LibraryDock::fill()
{
    const QDir place(folder());
    if (!m_watcher.directories().isEmpty())
        m_watcher.removePaths(m_watcher.directories());
    if (place.exists())
        m_watcher.addPath(place.path());
    m_cards.clear();
    std::vector<QWidget *> cards;
    const QStringList filters{io::patternOf(io::nativeFormat())};
    for (const QFileInfo &info : place.entryInfoList(filters, QDir::Files, QDir::Name)) {
        const QString path = info.absoluteFilePath();
        auto *card = new ModelCard(info.completeBaseName());
        card->setObjectName(QStringLiteral("libraryCard"));
        card->setToolTip(tr("Add it to the model"));
        connect(card, &QAbstractButton::clicked, this, [this, path] { Q_EMIT insertWanted(path); });
        const auto removeIt = [this, path] { remove(path); };
        connect(card, &ModelCard::removalWanted, this, removeIt, Qt::QueuedConnection);
        card->setContextMenuPolicy(Qt::ActionsContextMenu);
        auto *trash = new QAction(themedIcon(QStringLiteral("trash")), tr("Move to trash"), card);
        connect(trash, &QAction::triggered, this, removeIt, Qt::QueuedConnection);
        card->addAction(trash);
        m_cards.emplace(path, card);
        cards.push_back(card);
    }
    m_grid->setCards(cards);
    for (QWidget *card : cards)
        dress(card); // the window is dressed by then
    m_empty->setVisible(cards.empty());
    if (isVisible())
        requestPictures();
}

void LibraryDock::requestPictures()
{
    m_thumbnails.clear();
    for (const auto &[path, card] : m_cards)
        m_thumbnails.request(path, devicePixelRatioF());
}

void LibraryDock::showEvent(QShowEvent *event)
{
    QDockWidget::showEvent(event);
    fill();
}

void LibraryDock::changeEvent(QEvent *event)
{
    QDockWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && isVisible())
        requestPictures();
}

} // namespace fff::ui

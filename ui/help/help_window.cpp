#include "ui/help/help_window.h"

#include "ui/base/file_dialog.h"
#include "ui/base/theme.h"
#include "ui/help/keys_list.h"

#include <QAbstractTextDocumentLayout>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QResizeEvent>
#include <QScreen>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr QSize kFirstSize(880, 640);
constexpr int kBesideText = 32, kLeastList = 170, kRowHeight = 30; // px

const QString kKeysAddress = QStringLiteral("qrc:/help/keys");
const QString kCheatSheet = QStringLiteral("action:cheat-sheet");
const QString kLesson = QStringLiteral("lesson");

/// Its pictures are no wider than there is room for.
class PageBrowser : public QTextBrowser
{
public:
    using QTextBrowser::QTextBrowser;

    std::function<QString()> keys; // the page that has no file

    /// What reads Markdown takes the system's colour, which the dark theme has no contrast to.
    void colourLinks()
    {
        QTextCharFormat link;
        link.setForeground(theme().accent);
        for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
            for (auto it = block.begin(); !it.atEnd(); ++it)
                if (const QTextFragment words = it.fragment(); words.charFormat().isAnchor()) {
                    QTextCursor cursor(document());
                    cursor.setPosition(words.position());
                    cursor.setPosition(words.position() + words.length(), QTextCursor::KeepAnchor);
                    cursor.mergeCharFormat(link);
                }
    }

    QVariant loadResource(int type, const QUrl &name) override
    {
        if (type == QTextDocument::HtmlResource && name == QUrl(kKeysAddress))
            return keys();
        if (type != QTextDocument::ImageResource)
            return QTextBrowser::loadResource(type, name);
        QImage picture(QStringLiteral(":/help/") + name.fileName());
        const double room = devicePixelRatioF() * (viewport()->width() - kBesideText);
        if (room > 0.0 && picture.width() > room)
            picture = picture.scaledToWidth(static_cast<int>(room), Qt::SmoothTransformation);
        picture.setDevicePixelRatio(devicePixelRatioF());
        return picture;
    }

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        QTextBrowser::resizeEvent(event);
        if (event->oldSize().width() == event->size().width() || source().isEmpty())
            return;
        const int place = verticalScrollBar()->value();
        reload();
        colourLinks();
        verticalScrollBar()->setValue(place);
    }
};

QString pageAt(const QUrl &address)
{
    return QFileInfo(address.path()).completeBaseName();
}

/// Of the second level, from 0 on; invalid: there are not so many.
QTextBlock headingOf(const QTextDocument &document, int number)
{
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        if (block.blockFormat().headingLevel() == 2 && number-- == 0)
            return block;
    return {};
}

} // namespace

HelpWindow::HelpWindow(Actions actions, QWidget *parent)
    : QDialog(parent), m_actions(std::move(actions)), m_pages(new QListWidget(this))
{
    setObjectName(QStringLiteral("helpWindow"));
    setWindowTitle(tr("Help"));
    resize(kFirstSize.boundedTo(screen()->availableSize() - QSize(24, 44))); // for its frame
    m_pages->setObjectName(QStringLiteral("helpPages"));
    m_pages->setAccessibleName(tr("Pages"));
    m_pages->setFrameShape(QFrame::NoFrame);
    for (const QString &page : helpPages()) {
        auto *row = new QListWidgetItem(helpTitle(page), m_pages);
        row->setData(Qt::UserRole, page);
        row->setSizeHint({0, kRowHeight});
    }
    auto *text = new PageBrowser(this);
    text->keys = [this] { return keysHtml(keyGroups(m_actions())); };
    m_text = text;
    m_text->setObjectName(QStringLiteral("helpText"));
    m_text->setAccessibleName(tr("Help"));
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setOpenLinks(false);
    // Pictures are fitted to the width, which is not to change when the page turns out to be long.
    m_text->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    m_text->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_text->document()->setDocumentMargin(kBesideText / 2);
    auto *buttons = new QDialogButtonBox(this);
    QPushButton *back = buttons->addButton(tr("Back"), QDialogButtonBox::ActionRole);
    back->setObjectName(QStringLiteral("helpBack"));
    back->setAutoDefault(false);
    back->setEnabled(false);
    QPushButton *close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    close->setAutoDefault(false);
    connect(m_pages, &QListWidget::itemClicked, this,
            [this](const QListWidgetItem *row) { show({row->data(Qt::UserRole).toString()}); });
    connect(m_pages, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem *row) { show({row->data(Qt::UserRole).toString()}); });
    connect(m_text, &QTextBrowser::anchorClicked, this, &HelpWindow::follow);
    connect(m_text, &QTextBrowser::sourceChanged, this, &HelpWindow::markPage);
    connect(m_text, &QTextBrowser::historyChanged, text, &PageBrowser::colourLinks);
    connect(back, &QPushButton::clicked, m_text, &QTextBrowser::backward);
    connect(m_text, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *middle = new QHBoxLayout;
    middle->setSpacing(0);
    middle->addWidget(m_pages);
    middle->addWidget(m_text, 1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 12);
    column->addLayout(middle, 1);
    auto *row = new QHBoxLayout;
    row->setContentsMargins(16, 0, 16, 0);
    row->addWidget(buttons);
    column->addLayout(row);
    dress(this);
    int width = kLeastList;
    for (int i = 0; i < m_pages->count(); ++i)
        width = std::max(width, kBesideText + m_pages->fontMetrics().horizontalAdvance(
                                                  m_pages->item(i)->text()));
    m_pages->setFixedWidth(width);
}

void HelpWindow::open(const HelpTopic &topic)
{
    QDialog::show(); // so that the text has its width
    show(topic);
    raise();
    activateWindow();
    m_text->setFocus();
}

void HelpWindow::show(const HelpTopic &topic)
{
    const bool isKeys = topic.page == kKeysPage;
    if (const QUrl address = isKeys ? QUrl(kKeysAddress) : helpAddress(topic.page);
        m_text->source() != address)
        m_text->setSource(address,
                          isKeys ? QTextDocument::HtmlResource : QTextDocument::MarkdownResource);
    const QTextBlock heading =
        topic.heading < 0 ? QTextBlock() : headingOf(*m_text->document(), topic.heading);
    const double top = heading.isValid()
                           ? m_text->document()->documentLayout()->blockBoundingRect(heading).top()
                           : 0.0;
    m_text->verticalScrollBar()->setValue(static_cast<int>(top));
}

void HelpWindow::follow(const QUrl &link)
{
    if (link == QUrl(kCheatSheet))
        saveCheatSheet();
    else if (link.scheme() == kLesson)
        Q_EMIT lessonChosen(QStringLiteral(":/lessons/%1.fff").arg(link.path()));
    else
        show({pageAt(link)});
}

void HelpWindow::markPage(const QUrl &address)
{
    m_pages->setCurrentRow(static_cast<int>(helpPages().indexOf(pageAt(address))));
}

void HelpWindow::saveCheatSheet()
{
    FileDialog dialog(this, tr("Save the keys as a page"), documentsFolder(),
                      tr("PDF documents (*.pdf)"));
    dialog.setObjectName(QStringLiteral("cheatSheetDialog"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("pdf"));
    dialog.selectFile(tr("FlatFitFab keys") + QStringLiteral(".pdf"));
    const QString path = dialog.target();
    if (path.isEmpty() || writeCheatSheet(path, keyGroups(m_actions())))
        return;
    QMessageBox failed(QMessageBox::NoIcon, tr("Save the keys as a page"),
                       tr("%1 could not be written.").arg(QFileInfo(path).fileName()),
                       QMessageBox::Ok, this);
    dress(&failed);
    failed.exec();
}

} // namespace fff::ui

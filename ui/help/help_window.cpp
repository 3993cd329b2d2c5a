#include "ui/dialogs/help_window.h"

#include "ui/base/theme.h"
#include "ui/settings/languages.h"

#include <QDialogButtonBox>
#include <QFile>
#include <QLocale>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace fff::ui {

namespace {

constexpr QSize kFirstSize(720, 640);
constexpr int kBesideText = 32; // px

/// Its pictures are no wider than there is room for.
class PageBrowser : public QTextBrowser
{
public:
    using QTextBrowser::QTextBrowser;

    QVariant loadResource(int type, const QUrl &name) override
    {
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
        verticalScrollBar()->setValue(place);
    }
};

QUrl addressOf(const QString &page)
{
    const QString own = QStringLiteral("/help/%1/%2.md").arg(languageFor(QLocale()), page);
    const bool isThere = QFile::exists(u':' + own);
    return {QStringLiteral("qrc:") + (isThere ? own : QStringLiteral("/help/%1.md").arg(page))};
}

} // namespace

HelpWindow::HelpWindow(QWidget *parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("helpWindow"));
    setWindowTitle(tr("Help"));
    resize(kFirstSize);
    m_text = new PageBrowser(this);
    m_text->setObjectName(QStringLiteral("helpText"));
    m_text->setAccessibleName(tr("Help"));
    m_text->setFrameShape(QFrame::NoFrame);
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
    connect(back, &QPushButton::clicked, m_text, &QTextBrowser::backward);
    connect(m_text, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 12);
    column->addWidget(m_text, 1);
    auto *row = new QHBoxLayout;
    row->setContentsMargins(16, 0, 16, 0);
    row->addWidget(buttons);
    column->addLayout(row);
    dress(this);
}

void HelpWindow::open(const QString &page)
{
    if (const QUrl address = addressOf(page); m_text->source() != address)
        m_text->setSource(address, QTextDocument::MarkdownResource);
    show();
    raise();
    activateWindow();
    m_text->setFocus();
}

} // namespace fff::ui

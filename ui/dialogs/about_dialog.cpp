#include "ui/dialogs/about_dialog.h"

#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/dialogs/libraries.h"
#include "ui/view/heading_weight.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

namespace fff::ui {

AboutDialog::AboutDialog(QWidget *parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("aboutDialog"));
    setWindowTitle(tr("About FlatFitFab"));
    resize(680, 480);

    auto *tabs = new QTabWidget(this);
    tabs->addTab(makeLicences(), tr("Licences"));
    tabs->addTab(makeVersions(), tr("For bug reports"));
    auto *buttons = new QDialogButtonBox(this);
    QPushButton *close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    close->setDefault(true);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    column->addWidget(makeHead());
    column->addWidget(tabs, 1);
    column->addWidget(buttons);
    close->setFocus();
    dress(this);
}

QWidget *AboutDialog::makeHead()
{
    auto *head = new QWidget(this);
    auto *picture = new QLabel(head);
    picture->setPixmap(
        tintedPixmap(QStringLiteral("section"), 48, theme().accent, devicePixelRatioF()));
    auto *name = new QLabel(tr("FlatFitFab %1").arg(QStringLiteral(FFF_VERSION)), head);
    QFont font = name->font();
    font.setPointSizeF(font.pointSizeF() * 1.5);
    font.setWeight(headingWeight());
    name->setFont(font);
    auto *words = new QLabel(
        tr("Draw flat parts in 3D, see at once how they fit, and cut them. It works without an "
           "account, and nothing leaves this computer."),
        head);
    words->setWordWrap(true);
    auto *origin = new QLabel(
        tr("After “FlatFitFab: Interactive Modeling with Planar Sections” by J. McCrae, "
           "N. Umetani and K. Singh (UIST 2014). Free software under the GNU General Public "
           "License, version 3 or later."),
        head);
    origin->setWordWrap(true);
    origin->setForegroundRole(QPalette::PlaceholderText);
    auto *column = new QVBoxLayout;
    column->setSpacing(4);
    column->addWidget(name);
    column->addWidget(words);
    column->addWidget(origin);
    auto *row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(16);
    row->addWidget(picture, 0, Qt::AlignTop);
    row->addLayout(column, 1);
    return head;
}

QPlainTextEdit *AboutDialog::makeText(const char *name, const QString &accessibleName)
{
    auto *text = new QPlainTextEdit(this);
    text->setObjectName(QLatin1String(name));
    text->setAccessibleName(accessibleName);
    text->setReadOnly(true);
    text->setTabChangesFocus(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return text;
}

QWidget *AboutDialog::makeVersions()
{
    auto *page = new QWidget(this);
    QPlainTextEdit *text = makeText("aboutVersions", tr("For bug reports"));
    text->setPlainText(versionReport());
    auto *copy = new QPushButton(tr("Copy"), page);
    copy->setObjectName(QStringLiteral("aboutCopy"));
    copy->setAutoDefault(false);
    connect(copy, &QPushButton::clicked, text,
            [text] { QGuiApplication::clipboard()->setText(text->toPlainText()); });
    auto *column = new QVBoxLayout(page);
    column->addWidget(text);
    column->addWidget(copy, 0, Qt::AlignRight);
    return page;
}

QWidget *AboutDialog::makeLicences()
{
    auto *page = new QWidget(this);
    auto *list = new QListWidget(page);
    list->setObjectName(QStringLiteral("aboutLibraries"));
    list->setAccessibleName(tr("What this program is built with"));
    for (const Library &library : libraries())
        list->addItem(QString::fromUtf8(library.name));
    list->setFixedWidth(150);
    auto *facts = new QLabel(page);
    facts->setObjectName(QStringLiteral("aboutFacts"));
    facts->setTextFormat(Qt::PlainText);
    facts->setWordWrap(true);
    facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    QPlainTextEdit *text = makeText("aboutLicence", tr("Text of the licence"));
    text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    text->setLineWrapMode(QPlainTextEdit::WidgetWidth);
    connect(list, &QListWidget::currentRowChanged, page, [facts, text](int row) {
        if (row < 0)
            return;
        const Library &library = libraries()[static_cast<std::size_t>(row)];
        QStringList lines = {tr(library.purpose), QString::fromUtf8(library.copyright),
                             QString::fromUtf8(library.licence),
                             QString::fromUtf8(library.address)};
        lines.removeAll(QString());
        facts->setText(lines.join(QLatin1Char('\n')));
        text->setPlainText(licenceText(library));
    });
    list->setCurrentRow(0);
    auto *right = new QVBoxLayout;
    right->addWidget(facts);
    right->addWidget(text, 1);
    auto *row = new QHBoxLayout(page);
    row->setSpacing(12);
    row->addWidget(list);
    row->addLayout(right, 1);
    return page;
}

} // namespace fff::ui

#include "ui/help/help_pages.h"

#include "ui/settings/languages.h"

#include <QAction>
#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QMenu>
#include <QToolButton>

#include <algorithm>
#include <optional>

namespace fff::ui {

namespace {

struct HelpPagesTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::HelpPages)
};

struct Told
{
    std::string_view of;
    const char *page;
    int heading = -1;
};

/// Of commands whose ids begin so; the first that fits.
constexpr Told kTold[] = {
    {"operation.linear", "operations", 0},
    {"operation.revolve", "operations", 1},
    {"operation.blend", "operations", 2},
    {"operation.branch", "operations", 3},
    {"operation.grid", "operations", 4},
    {"operation.radial", "operations", 5},
    {"operation.mirror", "operations", 6},
    {"operation.symmetric", "operations", 6},
    {"mirror.", "operations", 6},
    {"edit.mirror", "operations", 6},
    {"operation.rotational", "operations", 7},
    {"operation.array", "operations", 8},
    {"operation.slices", "operations", 9},
    {"operation.", "operations"},
    {"joint.", "joints", 0},
    {"fabricate.coupon", "joints", 2},
    {"fabricate.stocks", "joints", 1},
    {"check.stress", "strength", 2},
    {"check.showAssembly", "first_steps", 10},
    {"check.", "strength", 0},
    {"physics.whereStrong", "strength", 3},
    {"physics.", "strength", 1},
    {"template.", "templates"},
    {"section.takeGuide", "templates", 0},
    {"view.skin", "templates", 4},
    {"fabricate.sheets", "cutting", 1},
    {"sheets.", "cutting", 1},
    {"file.export", "cutting"},
    {"section.pen", "first_steps", 4},
    {"section.", "more"},
    {"point.", "more"},
    {"transform.", "more"},
    {"measure.", "more"},
    {"mark.", "more"},
    {"value.", "more"},
    {"preset.", "more"},
    {"view.", "first_steps", 5},
};

/// Of parts of the window, by their class.
constexpr Told kToldOfParts[] = {
    {"fff::ui::ChecksDock", "strength", 0},   {"fff::ui::Badges", "strength", 0},
    {"fff::ui::PhysicsDock", "strength", 1},  {"fff::ui::LoadPage", "strength", 1},
    {"fff::ui::TemplatesDock", "templates"},  {"fff::ui::SheetsDock", "cutting", 1},
    {"fff::ui::ExportRows", "joints", 1},     {"fff::ui::ExportDialog", "cutting"},
    {"fff::ui::ExportButton", "cutting"},     {"fff::ui::StockBox", "joints", 1},
    {"fff::ui::StockEditor", "joints", 1},    {"fff::ui::JointPage", "joints", 0},
    {"fff::ui::OperationPage", "operations"}, {"fff::ui::SectionPage", "more"},
    {"fff::ui::ValuesDock", "more"},          {"fff::ui::LibraryDock", "more"},
    {"fff::ui::StepsBar", "first_steps", 10},
};

HelpTopic topicIn(const Told &told)
{
    return {QLatin1String(told.page), told.heading};
}

/// Its lines that begin with so many marks, without them.
QStringList headings(const QString &page, const QString &mark)
{
    QFile file(u':' + helpAddress(page).path());
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QStringList found;
    for (const QString &line : QString::fromUtf8(file.readAll()).split(u'\n'))
        if (line.startsWith(mark + u' '))
            found += line.mid(mark.size() + 1).trimmed();
    return found;
}

std::optional<HelpTopic> topicOfOne(const QWidget &widget)
{
    const QAction *action = nullptr;
    if (const auto *button = qobject_cast<const QToolButton *>(&widget))
        action = button->defaultAction();
    else if (const auto *menu = qobject_cast<const QMenu *>(&widget))
        action = menu->activeAction();
    if (action && !action->objectName().isEmpty())
        return topicOf(action->objectName().toStdString());
    const std::string_view name = widget.metaObject()->className();
    const auto *told = std::find_if(std::begin(kToldOfParts), std::end(kToldOfParts),
                                    [name](const Told &one) { return one.of == name; });
    return told == std::end(kToldOfParts) ? std::nullopt : std::optional(topicIn(*told));
}

} // namespace

const QStringList &helpPages()
{
    static const QStringList pages{
        QStringLiteral("first_steps"), QStringLiteral("operations"), QStringLiteral("joints"),
        QStringLiteral("strength"),    QStringLiteral("templates"),  QStringLiteral("cutting"),
        QStringLiteral("lessons"),     QStringLiteral("more"),       kKeysPage};
    return pages;
}

QUrl helpAddress(const QString &page)
{
    const QString own = QStringLiteral("/help/%1/%2.md").arg(languageFor(QLocale()), page);
    const bool isThere = QFile::exists(u':' + own);
    return {QStringLiteral("qrc:") + (isThere ? own : QStringLiteral("/help/%1.md").arg(page))};
}

QString helpTitle(const QString &page)
{
    return page == kKeysPage ? HelpPagesTexts::tr("Keys")
                             : headings(page, QStringLiteral("#")).value(0);
}

QStringList helpHeadings(const QString &page)
{
    return page == kKeysPage ? QStringList() : headings(page, QStringLiteral("##"));
}

HelpTopic topicOf(std::string_view command)
{
    const auto *told = std::find_if(std::begin(kTold), std::end(kTold), [command](const Told &one) {
        return command.starts_with(one.of);
    });
    if (told == std::end(kTold))
        return {helpPages().front()};
    return topicIn(*told);
}

HelpTopic topicAt(const QWidget *widget)
{
    for (; widget; widget = widget->parentWidget())
        if (const std::optional<HelpTopic> topic = topicOfOne(*widget))
            return *topic;
    return {helpPages().front()};
}

} // namespace fff::ui

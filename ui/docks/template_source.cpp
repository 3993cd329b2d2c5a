#include "ui/docks/template_source.h"

#include "core/model/template.h"
#include "ui/properties/property_rows.h"

#include <QFileInfo>
#include <QPushButton>
#include <QVBoxLayout>

namespace fff::ui {

namespace {

constexpr int kAboveSource = 4, kBelowSource = 6; // px

QString pathOf(const Template &one)
{
    return QString::fromStdString(one.file);
}

} // namespace

TemplateSource::TemplateSource(std::function<const Template *()> chosen, QWidget *parent)
    : QWidget(parent), m_chosen(std::move(chosen))
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, kBelowSource);
    column->setSpacing(kAboveSource);
    m_file = new TextRow(
        tr("Its file"), "templateFile",
        [this]() -> QString {
            const Template *one = m_chosen();
            if (!one)
                return {};
            if (!one->isRead())
                return tr("missing");
            return one->blob.empty() ? tr("read each time") : tr("kept in the model");
        },
        this);
    column->addWidget(m_file);
    const auto button = [&](const QString &text, const char *name, const QString &tip) {
        auto *made = new QPushButton(text, this);
        made->setObjectName(QLatin1String(name));
        made->setToolTip(tip);
        made->setAutoDefault(false);
        column->addWidget(made);
        return made;
    };
    m_find = button(tr("Find its file…"), "templateFind",
                    tr("Read it from where its file is now; it lies where it lay"));
    m_link = button(tr("Link to its file…"), "templateLink",
                    tr("Leave it out of the model's file, which gets smaller, and read it from "
                       "where it is each time"));
    m_keep = button(tr("Keep it in the model"), "templateKeep",
                    tr("Put it into the model's file, so that it is there on other computers"));
    connect(m_find, &QPushButton::clicked, this, [this] {
        if (const Template *one = m_chosen())
            Q_EMIT fileWanted(one->blob.empty());
    });
    connect(m_link, &QPushButton::clicked, this, [this] { Q_EMIT fileWanted(true); });
    connect(m_keep, &QPushButton::clicked, this, &TemplateSource::keepWanted);
}

void TemplateSource::refresh()
{
    m_file->refresh();
    const Template *one = m_chosen();
    const bool isRead = one && one->isRead(), isLinked = one && one->blob.empty();
    m_file->setToolTip(one ? pathOf(*one) : QString());
    m_find->setVisible(one && !isRead);
    m_link->setVisible(isRead && !isLinked);
    m_keep->setVisible(isRead && isLinked);
}

} // namespace fff::ui

#include "ui/properties/exception_rows.h"

#include "core/model/operation_edits.h"
#include "core/operations/evaluate.h"
#include "ui/properties/link_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

ExceptionRows::ExceptionRows(QWidget *parent) : QWidget(parent)
{
    m_none = new QLabel(tr("None. Click one section to leave it out or to detach it."), this);
    m_none->setObjectName(QStringLiteral("exceptionsNone"));
    m_none->setForegroundRole(QPalette::PlaceholderText);
    m_none->setWordWrap(true);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(2);
    column->addWidget(m_none);
}

void ExceptionRows::addRow()
{
    Row row;
    row.box = new QWidget(this);
    row.text = new QLabel(row.box);
    row.text->setTextFormat(Qt::PlainText);
    row.text->setWordWrap(true);
    row.link = new LinkRow(row.box);
    row.link->setObjectName(QStringLiteral("exceptionShow"));
    row.link->setTexts({tr("Show again")});
    auto *line = new QHBoxLayout(row.box);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    line->addWidget(row.text, 1);
    line->addWidget(row.link, 0);
    const std::size_t index = m_rows.size();
    connect(row.link, &LinkRow::clicked, this,
            [this, index] { Q_EMIT showWanted(m_rows[index].instance); });
    layout()->addWidget(row.box);
    m_rows.push_back(row);
}

QString ExceptionRows::nameOf(const Operation &operation, const std::string &key,
                              const Model &model)
{
    if (!(m_named == operation)) {
        m_named = operation;
        m_names.clear();
        Operation whole = operation;
        whole.exceptions.clear();
        whole.isOn = true;
        if (const Result<Document> document = setOperation(model.document, std::move(whole))) {
            const Model all = evaluate(*document, model);
            if (const OperationResult *result = all.resultOf(operation.id))
                for (const SectionPointer &section : result->sections)
                    m_names.emplace_back(section->made.key, QString::fromStdString(section->name));
        }
    }
    for (const auto &[known, name] : m_names)
        if (known == key)
            return name;
    return tr("No. %1").arg(QString::fromStdString(key));
}

void ExceptionRows::show(const Operation &operation, const Model &model)
{
    std::size_t count = 0;
    for (const auto &[key, exception] : operation.exceptions) {
        if (exception.state == Exception::State::Made)
            continue; // of another stock, which its own page says
        if (count == m_rows.size())
            addRow();
        Row &row = m_rows[count++];
        row.instance = SectionRef(operation.id, key);
        const QString name = nameOf(operation, key, model);
        row.text->setText(exception.state == Exception::State::Hidden
                              //: %1 is the name of a section
                              ? tr("%1, left out").arg(name)
                              //: %1 is the name of a section
                              : tr("%1, detached").arg(name));
        row.box->show();
    }
    for (std::size_t i = count; i < m_rows.size(); ++i)
        m_rows[i].box->hide();
    m_none->setVisible(count == 0);
}

} // namespace fff::ui

// The sections that an operation would make otherwise, each with what it is instead, and a way
// back.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/model.h"

#include <vector>

class QLabel;

namespace fff::ui {

class LinkRow;

class ExceptionRows : public QWidget
{
    Q_OBJECT
public:
    explicit ExceptionRows(QWidget *parent = nullptr);

    void show(const Operation &operation, const Model &model);

Q_SIGNALS:
    /// It is to be made as the others again.
    void showWanted(const fff::SectionRef &instance);

private:
    struct Row
    {
        QWidget *box = nullptr;
        QLabel *text = nullptr;
        LinkRow *link = nullptr;
        SectionRef instance;
    };
    void addRow();
    /// What the sections are called that are not made; each is asked for once.
    QString nameOf(const Operation &operation, const std::string &key, const Model &model);

    QLabel *m_none = nullptr;
    std::vector<Row> m_rows; // as many as there are exceptions, or more, hidden
    Operation m_named;       // whose sections these are called
    std::vector<std::pair<std::string, QString>> m_names;
};

} // namespace fff::ui

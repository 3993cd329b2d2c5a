// The Values dock and number fields in a person's hand, in a window without its view.
#pragma once

#include <QTest>

#include "tests/core/operations/driven_models.h"
#include "tests/ui/window_fixture.h"
#include "ui/docks/value_editor.h"
#include "ui/docks/value_row.h"
#include "ui/docks/values_dock.h"

#include <QAbstractSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include <memory>

namespace fff::ui {

inline Document withRange(Document document, const char *name, double least, double most)
{
    Value value = *document.values.find(std::string_view(name));
    value.range = {least, most, {}};
    return changeValue(std::move(document), std::move(value)).value();
}

/// A board whose stock is made of a value with a range, and another value.
inline Document adjustable()
{
    Document document = test::withValue(test::shelf(), "width", "40 mm");
    document = test::withValue(std::move(document), "half", "width/2");
    document = withRange(std::move(document), "width", 20.0, 80.0);
    return test::madeOf(std::move(document), test::stockKey(document, "thickness"), "width/10");
}

class ValuesHand
{
protected:
    void begin()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
        m_window = openWindow();
        m_window->resize(1440, 900);
        m_window->show();
        m_window->showDocument();
    }
    void end()
    {
        closeEverything();
        m_window = nullptr;
    }
    void open(const Document &document)
    {
        bench().session().reset(document);
        dock().toggleViewAction()->trigger();
        m_window->activateWindow();
        QTRY_VERIFY(dock().isVisible());
    }
    /// Again: offscreen the list of names takes that away.
    void activate()
    {
        m_window->activateWindow();
        QTRY_VERIFY(m_window->isActiveWindow());
    }
    Workbench &bench() { return m_window->bench(); }
    const Document &document() { return bench().session().committed().document; }
    ValuesDock &dock() { return *m_window->findChild<ValuesDock *>(); }
    ValueRow *row(const char *name)
    {
        for (ValueRow *one : m_window->findChildren<ValueRow *>())
            if (!one->isHidden() &&
                one->findChild<QLineEdit *>(QStringLiteral("valueName"))->text() ==
                    QLatin1String(name))
                return one;
        return nullptr;
    }
    template <class Widget>
    Widget *in(const char *name)
    {
        for (ValueEditor *editor : row(name)->findChildren<ValueEditor *>())
            for (Widget *widget : editor->findChildren<Widget *>())
                if (widget->isVisible()) // not in one that is on its way out
                    return widget;
        return nullptr;
    }
    template <class Widget>
    Widget *detail(const char *name, const char *id)
    {
        auto *more = row(name)->findChild<QToolButton *>(QStringLiteral("valueMore"));
        if (!row(name)->findChild<QWidget *>(QStringLiteral("valueKind")))
            QTest::mouseClick(more, Qt::LeftButton);
        return row(name)->findChild<Widget *>(QLatin1String(id));
    }
    void type(QWidget *field, const QString &text)
    {
        activate();
        field->setFocus();
        if (auto *number = qobject_cast<QAbstractSpinBox *>(field))
            number->selectAll();
        else
            qobject_cast<QLineEdit *>(field)->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    QString problem(const char *name)
    {
        auto *label = row(name)->findChild<QLabel *>(QStringLiteral("valueProblem"));
        return label->isVisible() ? label->text() : QString();
    }
    double thickness() { return document().stocks.front()->thickness; }
    double worth(const char *name)
    {
        const Model &model = bench().session().committed();
        return model.evaluation.values.worth(test::idOf(model.document, name))->number;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

} // namespace fff::ui

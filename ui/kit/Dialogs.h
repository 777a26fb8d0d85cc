#pragma once
/// The questions that the window asks in windows of their own; tests answer them without any.

#include <QString>

#include <functional>

#include "core/base/Progress.h"
#include "core/base/Result.h"

class QFileDialog;
class QPrinter;
class QSettings;
class QWidget;

namespace lubberline::ui {

class Dialogs {
public:
    virtual ~Dialogs() = default;
    /// @return the file chosen, or empty.
    virtual QString openFile(QWidget* parent, const QString& title, const QString& filter) = 0;
    /// The file's ending is that of the filter that was chosen, unless one was typed.
    virtual QString saveFile(QWidget* parent, const QString& title, const QString& suggestion, const QString& filter) = 0;
    /// @return the folder chosen, or empty.
    virtual QString chooseFolder(QWidget* parent, const QString& title, const QString& before) = 0;
    using PaintPages = std::function<Result<void>(QPrinter&, const Progress&)>;
    /// @param paint  called on a worker, however many pages there are; may be cancelled between two. What only the window's thread can
    /// paint, such as a widget, is `where` the window is.
    /// @return whether it was printed. Errors: those of `paint`; who cancels has not printed, and knows it.
    enum class Where { Worker, Window };
    virtual Result<bool> printPreview(QWidget* parent, const PaintPages& paint, Where where = Where::Worker) = 0;
    /// A file or folder in the program that the desktop has for it. @return false: there is none
    virtual bool openOutside(const QString& path) = 0;
};

/// Those of the desktop. They begin in the folder of the file that was chosen last, also the next time the program runs; a file that is
/// there already is asked about under its whole name, ending included.
class DesktopDialogs final : public Dialogs {
public:
    explicit DesktopDialogs(QSettings& settings) : m_settings(settings) {}
    QString openFile(QWidget* parent, const QString& title, const QString& filter) override;
    QString saveFile(QWidget* parent, const QString& title, const QString& suggestion, const QString& filter) override;
    QString chooseFolder(QWidget* parent, const QString& title, const QString& before) override;
    Result<bool> printPreview(QWidget* parent, const PaintPages& paint, Where where) override;
    bool openOutside(const QString& path) override;

private:
    QString ask(QFileDialog& dialog);
    QSettings& m_settings;
};

} // namespace lubberline::ui

#pragma once
/// A field stops where the stores would refuse: nobody types, or pastes, what is thrown back afterwards.

#include <QObject>

#include <functional>

class QLineEdit;
class QPlainTextEdit;

namespace lubberline::ui {

class LengthLimits : public QObject {
    Q_OBJECT

public:
    /// Of every text field that the program shows: kLongestText bytes of UTF-8, as the stores count. @param say is told when one is full.
    LengthLimits(std::function<void(const QString&)> say, QObject* parent);
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void limit(QLineEdit& field);
    void limit(QPlainTextEdit& field);
    void tell();
    std::function<void(const QString&)> m_say;
};

} // namespace lubberline::ui

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "core/base/Contract.h"
#include "core/base/Message.h"

namespace lubberline {

enum class ErrorCode {
    InvalidInput, ///< the data are wrong: the user can mend them
    Format,       ///< a file is not of the format that it should be
    NotFound,
    Io,      ///< a file cannot be opened, read or written
    Numeric, ///< the data are well formed, but no result exists (singular, folded)
    Unsupported,
    ReadOnly,
    Locked, ///< another program holds the database
    Full,   ///< no space left
    Corrupt,
    NewerSchema, ///< written by a newer version of the program
    Conflict,    ///< somebody else changed it, or it is there already and differs
    Frozen,      ///< the record is signed
    Cancelled,
};

/// What went wrong, in words for the user: what is wrong and what was expected.
struct Error {
    ErrorCode code = ErrorCode::InvalidInput;
    Message message;
    std::string file = {}; ///< empty when no file is concerned
    std::int64_t line = 0; ///< 1-based; 0 when no line is concerned
};

/// "FILE:LINE: message", leaving out what is not known.
[[nodiscard]] Message described(const Error& error);
/// The same in English: for commands, files and tests.
[[nodiscard]] std::string describe(const Error& error);

/// A value or the Error that explains why there is none.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool ok() const { return m_state.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() &
    {
        expectValue();
        return std::get<0>(m_state);
    }
    const T& value() const&
    {
        expectValue();
        return std::get<0>(m_state);
    }
    T&& value() &&
    {
        expectValue();
        return std::get<0>(std::move(m_state));
    }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    const Error& error() const
    {
        LUBBERLINE_EXPECT(!ok(), "a Result that is ok has no error");
        return std::get<1>(m_state);
    }

private:
    void expectValue() const { LUBBERLINE_EXPECT(ok(), "value() of a Result that is an error"); }
    std::variant<T, Error> m_state;
};

/// Success, or the Error that explains the failure.
template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : m_failed(true), m_error(std::move(error)) {}
    [[nodiscard]] bool ok() const { return !m_failed; }
    explicit operator bool() const { return ok(); }
    const Error& error() const
    {
        LUBBERLINE_EXPECT(m_failed, "a Result that is ok has no error");
        return m_error;
    }

private:
    bool m_failed = false;
    Error m_error;
};

/// Of a call whose value is not wanted: whether it went well.
template <class T>
[[nodiscard]] Result<void> noValue(const Result<T>& result)
{
    return result ? Result<void>() : Result<void>(result.error());
}

} // namespace lubberline

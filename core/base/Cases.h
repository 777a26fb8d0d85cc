#pragma once
/// One answer for each alternative of a variant, for std::visit: Cases{[](const Bar& b) {…}, [](const Plate& p) {…}}.

namespace lubberline {

template <class... Calls>
struct Cases : Calls... {
    using Calls::operator()...;
};
template <class... Calls>
Cases(Calls...) -> Cases<Calls...>; // clang 14, which fuzzes, does not deduce it by itself

} // namespace lubberline

#pragma once
/// Before all else in the sources that include qpdf, where clang 14 compiles them: it instantiates the destructor of a vector as soon as that
/// may be constexpr, and qpdf's JSON is not complete by then. Here no function of a vector is constexpr;
/// the one beside them that was declared so already, a fill of bits, goes by another name.

#include <bits/allocator.h>
#include <bits/functional_hash.h>
#include <bits/range_access.h>
#include <bits/stl_algobase.h>
#include <bits/stl_construct.h>
#include <bits/stl_uninitialized.h>
#include <debug/assertions.h>

#pragma push_macro("_GLIBCXX20_CONSTEXPR")
#undef _GLIBCXX20_CONSTEXPR
#define _GLIBCXX20_CONSTEXPR
#define __fill_a1 fillOfBits
#include <vector>
#undef __fill_a1
#pragma pop_macro("_GLIBCXX20_CONSTEXPR")

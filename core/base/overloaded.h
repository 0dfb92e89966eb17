#pragma once

namespace ps {

/// A function object with the call operators of several lambdas: std::visit calls the one for what a variant holds.
template <class... Lambdas>
struct Overloaded : Lambdas... {
  using Lambdas::operator()...;
};
template <class... Lambdas>
Overloaded(Lambdas...) -> Overloaded<Lambdas...>;

}  // namespace ps

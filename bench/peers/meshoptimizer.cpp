// SPDX-License-Identifier: GPL-3.0-or-later
// meshoptimizer's simplifiers. The clock covers the one call; the float positions and the index
// buffers exist before. A policy is a function and its options, as "update+Permissive+Prune".
#include <meshoptimizer.h>

#include <cfloat>
#include <map>
#include <sstream>

#include "peer.h"

namespace {

using Index = unsigned int;
constexpr std::size_t stride = 3 * sizeof(float);
constexpr float any_error = FLT_MAX;  // the face count alone stops

struct Buffers {
  std::vector<float> positions;
  std::vector<Index> indices;

  std::size_t vertices() const { return positions.size() / 3; }
};

struct Request {
  std::size_t target_indices;
  unsigned int options;
};

void simplify(Buffers& mesh, const Request& request) {
  std::vector<Index> result(mesh.indices.size());
  result.resize(meshopt_simplify(result.data(), mesh.indices.data(), mesh.indices.size(),
                                 mesh.positions.data(), mesh.vertices(), stride,
                                 request.target_indices, any_error, request.options, nullptr));
  mesh.indices.swap(result);
}

void update(Buffers& mesh, const Request& request) {
  mesh.indices.resize(
      meshopt_simplifyWithUpdate(mesh.indices.data(), mesh.indices.size(), mesh.positions.data(),
                                 mesh.vertices(), stride, nullptr, 0, nullptr, 0, nullptr,
                                 request.target_indices, any_error, request.options, nullptr));
}

void sloppy(Buffers& mesh, const Request& request) {
  std::vector<Index> result(mesh.indices.size());
  result.resize(meshopt_simplifySloppy(result.data(), mesh.indices.data(), mesh.indices.size(),
                                       mesh.positions.data(), mesh.vertices(), stride, nullptr,
                                       request.target_indices, any_error, nullptr));
  mesh.indices.swap(result);
}

template <class Value>
Value look_up(const std::map<std::string, Value>& table, const std::string& name) {
  const auto entry = table.find(name);
  if (entry == table.end()) throw std::invalid_argument("meshoptimizer: no " + name);
  return entry->second;
}

using Simplifier = void (*)(Buffers&, const Request&);

Simplifier simplifier_of(const std::string& name) {
  return look_up<Simplifier>({{"simplify", simplify}, {"update", update}, {"sloppy", sloppy}},
                             name);
}

unsigned int option_of(const std::string& name) {
  return look_up<unsigned int>({{"LockBorder", meshopt_SimplifyLockBorder},
                                {"Prune", meshopt_SimplifyPrune},
                                {"Regularize", meshopt_SimplifyRegularize},
                                {"Permissive", meshopt_SimplifyPermissive}},
                               name);
}

peer::Cost decimate(const std::string& policy, std::size_t target, peer::Mesh& mesh) {
  std::istringstream words(policy);
  std::string word;
  std::getline(words, word, '+');
  const Simplifier simplifier = simplifier_of(word);
  Request request{3 * target, 0};
  while (std::getline(words, word, '+')) request.options |= option_of(word);
  Buffers buffers{{mesh.points.begin(), mesh.points.end()},
                  {mesh.corners.begin(), mesh.corners.end()}};
  const peer::Cost cost = peer::measure([&] { simplifier(buffers, request); });
  mesh.points.assign(buffers.positions.begin(), buffers.positions.end());
  mesh.corners.assign(buffers.indices.begin(), buffers.indices.end());
  return cost;
}

std::string version() {
  constexpr int thousand = 1000, ten = 10;  // 1030 is 1.3
  const int number = MESHOPTIMIZER_VERSION;
  return std::to_string(number / thousand) + "." + std::to_string(number % thousand / ten);
}

}  // namespace

int main(int count, char** words) { return peer::run(count, words, version(), decimate); }

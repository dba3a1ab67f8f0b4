// SPDX-License-Identifier: GPL-3.0-or-later
// What every peer program shares: the mesh file, the clock, the peak memory and the command line.
#pragma once

#include <malloc.h>

#include <chrono>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace peer {

/// A triangle mesh as plain arrays; in a file: int64 vertices, int64 faces, doubles, int32 indices.
struct Mesh {
  std::vector<double> points;  ///< x y z of every vertex
  std::vector<std::int32_t> corners;

  std::size_t vertices() const { return points.size() / 3; }
  std::size_t faces() const { return corners.size() / 3; }
};

/// The call alone.
struct Cost {
  double seconds = 0.0;
  long peak_bytes = -1;  ///< growth of the resident memory at its peak; -1: not known here
};

/// The library says that it cannot take this mesh.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class T>
void read_all(std::istream& file, std::vector<T>& values, std::size_t count) {
  values.resize(count);
  file.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(count * sizeof(T)));
}

inline Mesh read_mesh(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<std::int64_t> sizes;
  read_all(file, sizes, 2);
  if (!file) throw std::runtime_error(path + ": no mesh file");
  Mesh mesh;
  read_all(file, mesh.points, 3 * static_cast<std::size_t>(sizes[0]));
  read_all(file, mesh.corners, 3 * static_cast<std::size_t>(sizes[1]));
  if (!file) throw std::runtime_error(path + ": the file ends too early");
  return mesh;
}

template <class T>
void write_all(std::ostream& file, const std::vector<T>& values) {
  file.write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(T)));
}

inline void write_mesh(const std::string& path, const Mesh& mesh) {
  std::ofstream file(path, std::ios::binary);
  write_all(file, std::vector<std::int64_t>{static_cast<std::int64_t>(mesh.vertices()),
                                            static_cast<std::int64_t>(mesh.faces())});
  write_all(file, mesh.points);
  write_all(file, mesh.corners);
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

/// A "VmRSS:   1234 kB" line of this process, in bytes.
inline long status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.compare(0, name.size() + 1, name + ":") == 0) {
      return std::stol(line.substr(name.size() + 1)) * 1024;
    }
  }
  return -1;
}

/// Makes the kernel forget the peak so far (Linux: 5 in clear_refs); false where it does not.
inline bool reset_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush;
  return file.good();
}

/// Runs the call once. Freed memory goes back first, so that the call does not grow into it unseen.
template <class Call>
Cost measure(Call&& call) {
  malloc_trim(0);
  const bool known = reset_peak();
  const long before = status_bytes("VmRSS");
  const auto start = std::chrono::steady_clock::now();
  call();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return {time.count(), known ? status_bytes("VmHWM") - before : -1};
}

/// PROGRAM --version, or PROGRAM POLICY TARGET_FACES INPUT OUTPUT: prints one line of JSON.
/// `decimate(policy, target, mesh)` replaces the mesh by its result and returns the cost of the
/// call. Ends with 3 when the library refuses the mesh, with 1 on any other error.
template <class Decimate>
int run(int count, char** words, const std::string& version, Decimate&& decimate) {
  if (count == 2 && std::string(words[1]) == "--version") {
    std::cout << version << '\n';
    return 0;
  }
  if (count != 5) {
    std::cerr << "usage: " << words[0] << " --version | POLICY TARGET_FACES INPUT OUTPUT\n";
    return 2;
  }
  try {
    Mesh mesh = read_mesh(words[3]);
    const Cost cost = decimate(std::string(words[1]), std::stoul(words[2]), mesh);
    write_mesh(words[4], mesh);
    std::cout.precision(9);
    std::cout << "{\"seconds\": " << cost.seconds << ", \"peak_bytes\": ";
    (cost.peak_bytes < 0 ? std::cout << "null" : std::cout << cost.peak_bytes) << "}\n";
    return 0;
  } catch (const Refused& refusal) {
    std::cerr << refusal.what() << '\n';
    return 3;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}

}  // namespace peer

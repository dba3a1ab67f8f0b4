// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <string>

#include "support/mesh_types.h"

namespace curvdecim::test {

/// The bytes of everything a mesh holds, to compare meshes bit for bit.
class Fingerprint {
 public:
  template <class Value>
  Fingerprint& add(const Value& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }

  Fingerprint& add(const vcg::Point3d& p) { return add(p[0]).add(p[1]).add(p[2]); }
  Fingerprint& add(const vcg::Color4b& c) { return add(c[0]).add(c[1]).add(c[2]).add(c[3]); }
  Fingerprint& add(const vcg::TexCoord2d& t) { return add(t.u()).add(t.v()).add(t.n()); }

  Fingerprint& add(const RichVertex& v) {
    return add(v.cP()).add(v.cN()).add(v.cQ()).add(v.cC()).add(v.cT()).add(v.cR()).add(v.cFlags());
  }

  /// All but the vertices that it refers to.
  Fingerprint& add(const RichFace& f) {
    add(f.cN()).add(f.cQ()).add(f.cC()).add(f.cFlags());
    for (int i = 0; i < 3; ++i) add(f.cWT(i));
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Deleted elements included; a mesh with the same bytes is the same mesh.
inline std::string bytes_of(const RichMesh& mesh) {
  Fingerprint print;
  print.add(mesh.vn).add(mesh.fn).add(mesh.bbox.min).add(mesh.bbox.max);
  for (const RichVertex& v : mesh.vert) print.add(v);
  for (const RichFace& f : mesh.face) {
    print.add(f);
    for (int i = 0; i < 3; ++i) print.add(f.cV(i) ? f.cV(i) - mesh.vert.data() : -1);
  }
  return print.bytes();
}

/// A face with all that its corners carry, but without indices: what "the same face" means after
/// compaction.
inline std::string bytes_of(const RichFace& face) {
  Fingerprint print;
  print.add(face);
  for (int i = 0; i < 3; ++i) print.add(*face.cV(i));
  return print.bytes();
}

}  // namespace curvdecim::test

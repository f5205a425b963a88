// Checks a mesh file, writes a certificate of every verdict, and has it verified by the independent program.
//
//   certificate MESH.msh VERIFIER
//
// The mesh is written exactly, as .bez.json, beside the certificate, which is about that file; so it works
// for every format that can be read.
#include <bezcert/bezcert.hpp>

#include <cstdlib>
#include <iostream>

int main(int argc, char** argv) {
  using namespace bezcert;
  if (argc != 3) {
    std::cerr << "usage: certificate MESH VERIFIER\n";
    return 2;
  }
  try {
    const Mesh mesh = read_mesh_file(argv[1]);
    const std::string elements = "example.bez.json", certificate = "example.cert";
    write_file(elements, [&](std::ostream& stream) { write_bez_json(stream, mesh); });
    write_file(certificate, [&](std::ostream& stream) {
      CertificateWriter writer(stream, {sha256(read_file(elements)), "mixed", Numbers::decimal});
      check_mesh(mesh, {}, writer);
    });
    std::cout << "written: " << elements << ", " << certificate << std::endl;

    const std::string command = '"' + std::string(argv[2]) + "\" " + elements + ' ' + certificate;
    return std::system(command.c_str()) == 0 ? 0 : 1;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}

#include "bezcert/decide/decide.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/read.hpp"
#include <iostream>
using namespace bezcert;
int main(int, char** argv){
  Mesh mesh=read_mesh(argv[1], read_file(argv[1]));
  for(size_t i=0;i<mesh.elements.size();++i){ Element e=mesh.element(i); Forms f(e); Decision d=decide(f);
    std::cout<<mesh.elements[i].tag<<" "<<name(d.verdict)<<" "<<d.injectivity_proof<<" "<<d.pieces<<" "<<to_decimal(to_rational(d.bounds.min_lower))<<" "<<to_decimal(to_rational(d.bounds.min_upper)); if(d.witness) std::cout<<" "<<to_string(d.witness->parameter)<<" "<<to_decimal(d.witness->determinant); std::cout<<" "<<d.open<<"\n";}
}

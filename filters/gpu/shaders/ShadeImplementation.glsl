  vec4 umbraSurface = umbraShade(vertexVC.xyz, normalVCVSOutput);
  vec3 umbraLight = umbraSurface.w * lightColor0;
  gl_FragData[1] = umbraSurface;
